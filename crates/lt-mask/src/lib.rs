#![no_std]
//! lt-mask
