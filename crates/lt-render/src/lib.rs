//! lt-render
