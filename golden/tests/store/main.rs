//! The store of goldens, and what it survives.

mod cases;
mod concurrent;
mod damage;
mod failing;
mod interrupted;
mod killed;
