#![no_std]
//! lt-bvh
