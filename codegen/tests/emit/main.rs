//! What leaves `emit`: names, docs, form, and whether other tools accept it.
#![allow(unreachable_pub, reason = "modules of one test program")]

mod accepted;
mod common;
mod entry;
mod groups;
mod names;
mod reflect;
mod text;
