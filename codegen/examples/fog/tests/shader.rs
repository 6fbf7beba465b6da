//! The shader, as the build script wrote it, returns what the kernels return: the same bits.

use fog::host;
use fog_kernels::{Fog, Sg, Sight, fog_apply};
use lobe_backends::interp::{Buffer, Interpreter};
use lobe_codegen::glam::Vec3;
use std::error::Error;

/// More than a workgroup, and not a multiple of one.
const PIXELS: usize = 100;

/// A row of pixels from straight down to straight up.
fn sights() -> Vec<Sight> {
    let sight = |i: usize| {
        let angle = (i as f32 / (PIXELS - 1) as f32 - 0.5) * std::f32::consts::PI;
        let view = Vec3::new(angle.cos(), 0.0, angle.sin());
        Sight { view, dist: 20.0 * i as f32, radiance: Vec3::new(1.0, 0.5, 0.25), height: 10.0 }
    };
    (0..PIXELS).map(sight).collect()
}

fn as_bytes(sight: &Sight) -> host::Sight {
    let Sight { view, dist, radiance, height } = *sight;
    host::Sight { view: view.to_array(), dist, radiance: radiance.to_array(), height }
}

#[test]
fn the_shader_returns_what_the_kernels_do() -> Result<(), Box<dyn Error>> {
    let albedo = Vec3::new(0.9, 0.95, 1.0);
    let fog = Fog { albedo, extinction: 0.002, falloff: 0.01, phase_sharpness: 8.0 };
    let light = Sg { axis: Vec3::new(0.8, 0.0, 0.6), sharpness: 400.0, log_amplitude: 3.0 };
    let sights = sights();

    let fog_bytes = host::Fog {
        albedo: albedo.to_array(),
        extinction: fog.extinction,
        falloff: fog.falloff,
        phase_sharpness: fog.phase_sharpness,
        ..bytemuck::Zeroable::zeroed()
    };
    let light_bytes = host::Sg {
        axis: light.axis.to_array(),
        sharpness: light.sharpness,
        log_amplitude: light.log_amplitude,
        ..bytemuck::Zeroable::zeroed()
    };
    let sights_bytes: Vec<host::Sight> = sights.iter().map(as_bytes).collect();

    let module = lobe_codegen::validate::from_wgsl(fog::WGSL)?;
    let mut buffers = [
        Buffer::copied(0, 0, bytemuck::bytes_of(&fog_bytes)),
        Buffer::copied(0, 1, bytemuck::bytes_of(&light_bytes)),
        Buffer::copied(0, 2, bytemuck::cast_slice(&sights_bytes)),
        Buffer::copied(0, 3, &[0; 16 * PIXELS]),
    ];
    let groups = PIXELS.div_ceil(fog::WORKGROUP) as u32;
    Interpreter::new(&module)?.run(0, [groups, 1, 1], &mut buffers[..])?;

    // Three floats take the room of four.
    let found: &[[f32; 4]] = bytemuck::cast_slice(&buffers[3].data);
    for (sight, found) in sights.iter().zip(found) {
        assert_eq!(found[..3], fog_apply(fog, light, *sight).to_array());
    }
    Ok(())
}

#[test]
fn the_description_names_the_pass_and_its_buffers() {
    for part in ["\"fog_pass\"", "\"sights\"", "\"phase_sharpness\""] {
        assert!(fog::REFLECTION.contains(part), "no {part}");
    }
    assert!(fog::HLSL.contains("void fog_pass("));
}
