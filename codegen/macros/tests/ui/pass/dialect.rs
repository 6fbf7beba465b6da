//! Statements and expressions of the language, without a warning.
#![deny(warnings)]
use lobe_codegen::prelude::*;

mod deep {
    use lobe_codegen::prelude::*;

    #[kernel]
    pub fn square(x: f32) -> f32 {
        x * x
    }
}

#[kernel]
fn everything(mut x: f32, n: i32, a: [f32; 3], m: Mat3) -> f32 {
    let late;
    let typed: u32 = 3;
    let _ = typed;
    let _ignored = [[0.0; 3]; 2];
    if n > 0 && x < 1.0 {
        late = 1.0;
    } else if n == -4 {
        late = 2.0
    } else {
        return deep::square(x);
    }
    for i in 0..=n {
        match i {
            -1 | 0x2 => continue,
            3 => break,
            4 | 5 => x += 1.0,
            _ => {}
        }
    }
    while x > 3.0 {
        x -= 1.0;
    }
    loop {
        x *= 2.0;
        if x > 100.0 || x != x {
            break;
        }
    }
    let b = {
        let c = a[(n & 1) as usize];
        c + m.x_axis.y
    };
    let v = Vec3::new(x, 1.0, b);
    select(late, b, n > 2) + v.zyx().x + std::f32::consts::PI + (n << 2) as f32 + (!n) as f32
}

fn main() {}
