//! Writes what `src/lib.rs` includes: the shader in WGSL and HLSL, its description, and structures for Rust.

use fog_kernels::fog_pass;
use lobe_codegen::emit::{Host, Options, Target, emit, host, reflect};
use std::error::Error;
use std::path::PathBuf;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // As text: an error shows the Rust line that it comes from.
    if let Err(error) = write_shaders() {
        eprintln!("{error}");
        std::process::exit(1);
    }
}

fn write_shaders() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::var("OUT_DIR")?);
    let module = lobe_codegen::lower(&lobe_codegen::kernels![fog_pass])?;
    let options = Options { command: Some("cargo build".to_owned()), ..Options::default() };
    for target in [Target::Wgsl, Target::Hlsl] {
        let artifact = emit(&module, target, &options)?;
        std::fs::write(folder.join(format!("fog.{}", target.extension())), artifact.content.bytes())?;
    }
    std::fs::write(folder.join("fog.json"), reflect(&module).to_json()?)?;
    std::fs::write(folder.join("fog.rs"), host(&module, Host::Rust))?;
    Ok(())
}
