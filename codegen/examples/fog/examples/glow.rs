//! Fog around a low sun, on the first Vulkan driver of this machine: `cargo run --example glow`.

use fog::host::{Fog, Sg, Sight};
use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, Job, Shader};
use std::error::Error;

const PIXELS: usize = 19;

fn main() -> Result<(), Box<dyn Error>> {
    let Some(driver) = gpu::drivers().into_iter().next() else {
        println!("no Vulkan driver was found; Mesa's lavapipe needs no graphics card");
        return Ok(());
    };
    // 10 degrees above the horizon.
    let sun = Sg {
        axis: [0.985, 0.0, 0.174],
        sharpness: 2000.0,
        log_amplitude: 6.0,
        ..bytemuck::Zeroable::zeroed()
    };
    let fog = Fog {
        albedo: [0.9, 0.95, 1.0],
        extinction: 0.002,
        falloff: 0.01,
        phase_sharpness: 8.0,
        ..bytemuck::Zeroable::zeroed()
    };
    // Along the horizon, from the sun to what is behind the eye.
    let sights: Vec<Sight> = (0..PIXELS).map(|i| along_the_horizon(10.0 * i as f32)).collect();

    let uniform =
        |binding, data| Binding { group: 0, binding, element: None, kind: BindingKind::Uniform, data };
    let bindings = [
        uniform(0, bytemuck::bytes_of(&fog)),
        uniform(1, bytemuck::bytes_of(&sun)),
        Binding { kind: BindingKind::StorageRead, ..uniform(2, bytemuck::cast_slice(&sights)) },
        Binding { kind: BindingKind::StorageReadWrite, ..uniform(3, &[0; 16 * PIXELS]) },
    ];
    let outputs = Gpu::open(&driver)?.run(&Job {
        shader: Shader::Wgsl(fog::WGSL),
        entry: "fog_pass",
        workgroup_size: [fog::WORKGROUP as u32, 1, 1],
        groups: [PIXELS.div_ceil(fog::WORKGROUP) as u32, 1, 1],
        bindings: &bindings,
        immediates: &[],
    })?;

    println!("on {}\nfrom the sun   red    green  blue", driver.name);
    for (i, [r, g, b, _]) in bytemuck::cast_slice::<u8, [f32; 4]>(&outputs[0]).iter().enumerate() {
        println!("{:9}°   {r:.3}  {g:.3}  {b:.3}", 10 * i);
    }
    Ok(())
}

/// A grey surface 500 m away.
fn along_the_horizon(degrees: f32) -> Sight {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Sight { view: [cosine, sine, 0.0], dist: 500.0, radiance: [0.2; 3], height: 2.0 }
}
