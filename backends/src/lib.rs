//! Executors of kernels.
//!
//! [`interp`] runs naga IR on the CPU: strictly, bit for bit like the native functions, or with a bound on
//! what any driver that keeps the shading languages' accuracy rules may return.

pub mod interp;
