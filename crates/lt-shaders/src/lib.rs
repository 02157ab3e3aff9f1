#![no_std]
//! lt-shaders
