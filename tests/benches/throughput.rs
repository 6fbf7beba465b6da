//! Throughput of the interpreter against lavapipe: what `lobe bench` measures, without building the rest.
//!
//! `cargo bench -p lobe-tests --bench throughput [-- KERNEL ...]`; `RAYON_NUM_THREADS=1 LP_NUM_THREADS=1` for one
//! thread. Prints the median time of each executor, and the median ratio to lavapipe.

use lobe_backends::gpu::{self, Gpu};
use lobe_backends::interp::Isa;
use lobe_backends::route::Road;
use lobe_tests::throughput::{Executor, WORKLOADS, measure};

const ROUNDS: usize = 9;

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let mut executors: Vec<Executor> = Isa::available().into_iter().map(Executor::Interp).collect();
    for driver in gpu::drivers().iter().filter(|d| d.name == "lavapipe") {
        let gpu = Gpu::open(driver).unwrap_or_else(|e| panic!("{e}"));
        executors.push(Executor::Gpu { road: Road::WgslNaga, gpu: Box::new(gpu) });
    }
    for maker in WORKLOADS.iter().filter(|w| wanted.is_empty() || wanted.iter().any(|name| name == w.name)) {
        let measured = measure(&maker.make(maker.items), &mut executors, ROUNDS);
        for m in measured.unwrap_or_else(|e| panic!("{e}")) {
            let ratio = m.ratio_to.get("wgsl+naga@lavapipe").map(|r| format!("{r:.2} x lavapipe"));
            println!(
                "{:8} {:20} {:8.2} ms  {}",
                m.kernel,
                m.name(),
                m.seconds * 1e3,
                ratio.unwrap_or_default()
            );
        }
    }
}
