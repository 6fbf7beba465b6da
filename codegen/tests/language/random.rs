//! Written by `generate.rs`; do not edit.

use crate::check::agrees;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
struct Duo {
    n: i32,
    w: Vec3,
}

#[kernel]
fn helper(a: i32, b: i32) -> i32 {
    if a > b {
        return b.wrapping_sub(a);
    }
    a.wrapping_mul(3) ^ b
}

#[kernel]
fn random_0(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    for v1 in -1i32..1 { if ({ true } && { pb }) { let mut v2 = (!false && (false && pb));
    let v4 = match (if pb { 1i32 } else { pi }) { 1 => continue, 0 | 4 => 4.5, _ => { let v3;
    if (pv == pv) { v3 = Duo { n: (2.625 as i32), ..Duo { n: 2i32, ..Duo { n: v1, w: pv } } };
    } else { v3 = Duo { w: pv, n: pi };
    } { 0.875 } } };
    } let mut v5 = 0i32;
    while pb { v5 += 1;
    if v5 > 5 { break;
    } { if ((Vec3::new(pf, pf, 1.5) == pv) ^ (2.75 >= 3.875)) { let mut v6 = Duo { w: (Vec3::new(pf, pf, 1.5) * pf), n: (v5 >> (pu & 7)) };
    v6 = Duo { n: (pu as i32), ..Duo { n: v1, ..v6 } };
    } } } let mut v7 = Duo { w: (if false { pv } else { pv }), n: (pf as i32) };
    } if (Vec3::new(pf, pf, 1.5) == pv) { return (pf + pf);
    } if (if pb { true } else { pb }) { return (if pb { pf } else { pf });
    } { let mut v8 = (helper(pi, 4i32) < pi);
    }
    (Vec3::new((pi as f32), (pf - pf), (pi as f32))).dot(((pv * pf) * (if pb { pf } else { 3.75 })))
}

#[kernel]
fn random_1(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if { pb } { let v1 = (if (pb && pb) { pi } else { pi });
    } let mut v2 = ((if pb { pu } else { pu }) % 7);
    if false { v2 = ((4i32 as u32) << 2);
    } { let mut v3 = 0i32;
    loop { v3 += 1;
    if v3 > 5 { break;
    } { let mut v4 = Duo { w: pv, n: (pi).wrapping_add(v3) };
    if (9i32 < 7i32) { return (pf + pf);
    } } } }
    0.0
}

#[kernel]
fn random_2(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = Duo { n: pi, w: Vec3::new(pf, pf, 1.5) };
    let mut v2: f32 = (match pi { -1 | 2 => { pf } 3 => { pf } _ => { pf } });
    let mut v3 = 0i32;
    while (6u32 == pu) { v3 += 1;
    if v3 > 5 { break;
    } { if ((Vec3::new(pf, v2, 1.5) == pv) || (pi < pi)) { v2 = (if (pv == Vec3::new(3.0, pf, 1.5)) { pf } else { v2 });
    if (4u32 == 4u32) { return (pv).dot(pv);
    } let mut v4 = ((Duo { n: pi, w: pv }).w + (v1).w);
    } } } v2 = (helper(pi, pi) as f32);
    min(((pi as f32) * (Vec3::new(v2, 3.375, 1.5)).dot(pv)), (Vec3::new(v2, 3.125, 4.25)).y)
}

#[kernel]
fn random_3(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = ([pi, pi, pi])[(({ let k = 6;
    k | 1u32 }) % 3) as usize];
    { let mut v2 = true;
    for v3 in -2i32..=4 { v1 = ({ Duo { n: pi, w: pv } }).n;
    if (4.5 >= pf) { return (if false { pf } else { pf });
    } } }{ let mut v4 = { [pi, 2, 3] };
    }let mut v5 = ((pu << 2) ^ (7i32 as u32));
    (((pu as i32) as f32) * ((match pi { -1 | 2 => { pv } 3 => { Vec3::new(pf, 4.0, 1.5) } _ => { Vec3::new(pf, pf, 1.5) } })).dot((pv * 4.625)))
}

#[kernel]
fn random_4(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1 = (match { pi } { -1 | 2 => { [pi, 2, 3] } 3 => { [pi, 2, 3] } _ => { [1i32, 2, 3] } });
    let mut v2: f32 = ((pf - 2.0) - (if pb { pf } else { 3.875 }));
    v2 = (pv).dot(pv);
    if (pb || pb) { return (if pb { 3.5 } else { 1.5 });
    }
    (match (if !pb { pi } else { pi }) { -1 | 2 => { let mut v3 = Duo { w: (pv * 4.0), n: pi }; let mut v4 = (if (pv == pv) { pu } else { pu }); pf } 3 => { v2 = (2.625 + (pv).y); v2 *= min(min(0.25, pf), 1.0); (pf - v2) } _ => { v2 } })
}

#[kernel]
fn random_5(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1;
    if (pv == pv) { v1 = [(if pb { pi } else { 2i32 }), (if true { pi } else { pi }), 0i32];
    } else { v1 = [9i32, pi, pi];
    } let v2 = Duo { n: (if pb { 3i32 } else { pi }), ..Duo { w: pv, n: pi } };
    let mut v3: f32 = (pv).y;
    v3 *= { v3 };
    (((Vec3::new(v3, 3.25, 1.5) + pv)).y * ((pb as i32) as f32))
}

#[kernel]
fn random_6(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    { let v1;
    if (pv == Vec3::new(1.25, pf, 1.5)) { v1 = Duo { n: pi, w: pv };
    } else { v1 = Duo { w: Vec3::new(0.5, pf, 1.5), n: 0i32 };
    } }let mut v2 = (if (pv == pv) { [pi, 2, 3] } else { [pi, 2, 3] });
    if (if (pb || pb) { pb } else { pb }) { v2[1] = ((if pb { 3i32 } else { pi }) >> ((match pi { -1 | 2 => { pu } 3 => { pu } _ => { pu } }) & 7));
    } v2[1] = ((if pb { pi } else { pi }) & pi);
    (((pf * 3.875) * 4.875) + (match (v2)[(pu % 3) as usize] { -1 | 2 => { pf } 3 => { pf } _ => { pf } }))
}

#[kernel]
fn random_7(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    { let v1;
    if (pb || pb) { v1 = (pi as u32);
    } else { v1 = (if pb { 9u32 } else { pu });
    } let mut v2 = { pv };
    { if (match 6i32 { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { return min(3.625, pf);
    } let v3;
    if (pf >= pf) { v3 = (if (Vec3::new(pf, 1.0, 1.5) == pv) { [pi, 2, 3] } else { [pi, 2, 3] });
    } else { v3 = [8i32, 0i32, 3i32];
    } }}{ { let v4;
    if { false } { v4 = ({ let k = 6;
    k | 9u32 });
    } else { v4 = (match pi { -1 | 2 => { pu } 3 => { pu } _ => { pu } });
    } let v5 = ((pi >> (v4 & 7)) & (match pi { -1 | 2 => { pi } 3 => { pi } _ => { 5i32 } }));
    match (pi as u32) { 0 | 1 => { let mut v6 = [(Duo { n: v5, w: pv }).n, (Duo { n: pi, w: pv }).n, (match pi { -1 | 2 => { pi } 3 => { v5 } _ => { v5 } })];
    v6[(((v4).wrapping_add(5u32) << 2) % 3) as usize] ^= 1i32;
    } 2 => { let mut v7 = ((v4 << 2) % 7);
    v7 = (({ let k = 6;
    k | v7 }) ^ (7u32 % 7));
    } _ => { let mut v8 = v5;
    v8 ^= (helper(v8, v5) & (if pb { pi } else { 3i32 }));
    } } }}{ let mut v9 = (if (if true { pb } else { pb }) { Duo { n: pi, w: Vec3::new(pf, pf, 1.5) } } else { Duo { n: 9i32, w: pv } });
    }let mut v10 = (match helper(pi, 5i32) { -1 | 2 => { Duo { n: pi, w: pv } } 3 => { Duo { n: 4i32, w: pv } } _ => { Duo { n: pi, w: pv } } });
    ((if !pb { pf } else { pf }) + pf)
}

#[kernel]
fn random_8(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    for v1 in 0i32..=4 { let v2: f32 = pf;
    let v3;
    if (if pb { true } else { true }) { v3 = (5 ^ (1i32 & 6i32));
    } else { v3 = (pb as i32);
    } let v4;
    if (pv == pv) { v4 = Duo { n: ([v3, 2, 3])[(pu % 3) as usize], ..Duo { n: v1, ..Duo { n: 1i32, w: Vec3::new(pf, 0.125, 1.5) } } };
    } else { v4 = (if pb { Duo { n: pi, w: pv } } else { Duo { n: 0i32, w: pv } });
    } } let mut v5 = ({ pu }).wrapping_add((pu ^ pu));
    if ((pf - pf) >= (5i32 as f32)) { v5 |= ((pu).wrapping_add(pu) ^ (pu ^ v5));
    v5 |= v5;
    v5 |= ((if pb { pu } else { v5 }) ^ (pu % 7));
    } if ((3i32 & pi) < (pi & pi)) { if pb { return (pf + pf);
    } } else { let v6 = ((Vec3::new(pf, pf, 1.5) * pf) * (pv).y);
    }
    { (if pb { 3.5 } else { pf }) }
}

#[kernel]
fn random_9(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if (if !pb { pb } else { pb }) { let v1;
    if (pf >= pf) { v1 = (pf * (pf - 2.125));
    } else { v1 = { pf };
    } let v2;
    if (v1 >= 1.75) { v2 = (min(0.625, v1) + (pv).y);
    } else { v2 = (2.375 * v1);
    } } else { let v3 = Vec3::new((4.125 * pf), 3.125, (match pi { -1 | 2 => { 0.5 } 3 => { pf } _ => { pf } }));
    let mut v4 = true;
    v4 &= v4;
    } let v5;
    if (pu == pu) { v5 = [pi, ([pi, 2, 3])[(pu % 3) as usize], (match pi { -1 | 2 => { 9i32 } 3 => { pi } _ => { pi } })];
    } else { v5 = { [pi, 2, 3] };
    } let mut v6 = (match (pi & 6i32) { -1 | 2 => { Duo { n: 4i32, w: pv } } 3 => { Duo { n: pi, w: Vec3::new(pf, pf, 1.5) } } _ => { Duo { n: pi, w: pv } } });
    v6.n = ((pi).wrapping_mul(2i32)).wrapping_add((pu as i32));
    min(pf, ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { pf } }) + (4i32 as f32)))
}

#[kernel]
fn random_10(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = ({ let k = 6;
    k | pu });
    let mut v2: f32 = pf;
    if (pb ^ pb) { v1 = { 5u32 };
    v1 = (if { true } { pu } else { pu });
    v2 += min((Vec3::new(v2, pf, 1.5)).y, (if pb { v2 } else { v2 }));
    } if { pb } { v1 = (match { pi } { -1 | 2 => { pu } 3 => { v1 } _ => { pu } });
    } else { { let mut v3 = 0i32;
    while (true && pb) { v3 += 1;
    if v3 > 5 { break;
    } { let mut v4 = ({ 5i32 } as u32);
    v4 = ({ v3 } as u32);
    v4 |= v1;
    } } }let mut v5 = [6i32, 2, 3];
    { let mut v6 = ((pi).wrapping_add(pi)).wrapping_mul(pi);
    let v7;
    if (4.375 >= v2) { v7 = (v1 << 2);
    } else { v7 = { v1 };
    } }}
    v2
}

#[kernel]
fn random_11(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = ({ let k = 6;
    k | (pu).wrapping_add(pu) });
    if ((2i32 < pi) || pb) { let mut v2 = pv;
    } let mut v3 = (match (match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }) { -1 | 2 => { Duo { n: pi, w: pv } } 3 => { Duo { n: pi, w: pv } } _ => { Duo { n: pi, w: Vec3::new(pf, pf, 1.5) } } });
    if { false } { return (3.5 * pf);
    }
    4.125
}

#[kernel]
fn random_12(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = (if (false ^ pb) { pi } else { 2i32 });
    let mut v2 = [v1, { v1 }, (9i32 & pi)];
    for v3 in 0i32..=4 { let v5 = match (v2)[(pu % 3) as usize] { 1 => continue, 0 | 4 => (pv * pf), _ => { let v4 = ({ 9i32 }).wrapping_mul({ v3 });
    (pv + pv) } };
    if { pb } { if { false } { v2[1] = (({ let k = 6;
    k | pu }) as i32);
    v2[(((if pb { 6i32 } else { pi }) as u32) % 3) as usize] ^= v1;
    } } if (match helper(pi, pi) { -1 | 2 => { true } 3 => { false } _ => { pb } }) { let v6;
    if (if pb { pb } else { true }) { v6 = (if (pf >= pf) { [pi, 2, 3] } else { v2 });
    } else { v6 = [v3, v1, pi];
    } } } let mut v7 = 0i32;
    while (5u32 == pu) { v7 += 1;
    if v7 > 5 { break;
    } { let v8 = Duo { w: { pv }, n: (Duo { n: pi, w: Vec3::new(pf, pf, 1.5) }).n };
    let mut v9 = { pv };
    v1 = ((1.875 * pf) as i32);
    } }
    pf
}

#[kernel]
fn random_13(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = (if (pb ^ pb) { 3i32 } else { pi });
    if ((pu ^ pu) == (pu ^ 4u32)) { if false { { v1 = ([v1, v1, v1])[(pu % 3) as usize];
    }match ({ let k = 6;
    k | pu }) { 0 | 1 => { let v2 = pu;
    let v3: f32 = ((Duo { n: v1, w: pv }).w).y;
    } 2 => { let mut v4 = (pu as i32);
    v1 ^= v1;
    } _ => { v1 ^= v1;
    v1 = ((1i32).wrapping_add(pi) & (v1 >> (pu & 7)));
    v1 ^= (v1).wrapping_mul(([v1, 2, 3])[(0u32 % 3) as usize]);
    } } } let mut v5: f32 = (if (pb ^ pb) { 1.5 } else { pf });
    if ((pb || pb) && (pb ^ false)) { v5 = pf;
    } else { match ({ let k = 6;
    k | 0u32 }) { 0 | 1 => { v5 = ((pv).y - (pf - pf));
    let v6;
    if pb { v6 = (if (if pb { pb } else { false }) { pv } else { pv });
    } else { v6 = (if pb { pv } else { pv });
    } } 2 => { v1 ^= (match (match 5i32 { -1 | 2 => { pi } 3 => { v1 } _ => { v1 } }) { -1 | 2 => { v1 } 3 => { v1 } _ => { pi } });
    } _ => { let v7;
    if (pb ^ pb) { v7 = Duo { n: (pi).wrapping_mul(9i32), ..Duo { n: v1, w: pv } };
    } else { v7 = Duo { n: pi, w: Vec3::new(pf, pf, 1.5) };
    } } } let v8 = [5i32, pi, (0i32 >> (pu & 7))];
    if pb { v1 ^= v1;
    } } } let mut v9: f32 = pf;
    { match (match 3i32 { -1 | 2 => { 7u32 } 3 => { 6u32 } _ => { pu } }) { 0 | 1 => { let v10: f32 = ((v9 + 0.75) * (if pb { pf } else { 2.375 }));
    } 2 => { if (match (pu as i32) { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { v9 += min((1i32 as f32), (if pb { pf } else { 2.25 }));
    v9 = { pf };
    v1 ^= { pi };
    } if (match helper(v1, 0i32) { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { let mut v11 = [(match 3i32 { -1 | 2 => { 7i32 } 3 => { pi } _ => { 2i32 } }), 1i32, (v1).wrapping_add(v1)];
    v11[1] = v1;
    v11[((if (pb ^ pb) { pu } else { pu }) % 3) as usize] ^= pi;
    } else { let v12;
    if false { v12 = (Vec3::new(v9, 1.25, v9)).dot((pv + pv));
    } else { v12 = (v9 + pf);
    } } } _ => { v9 = (min(v9, v9) * (pv).dot(pv));
    } } v9 *= pf;
    v1 = v1;
    }
    (if pb { if (match (if pb { v1 } else { 1i32 }) { -1 | 2 => { pb } 3 => { false } _ => { pb } }) { v1 = v1; } else { let mut v13 = 9u32; let mut v14 = ((match pi { -1 | 2 => { v1 } 3 => { pi } _ => { v1 } }) < (match pi { -1 | 2 => { pi } 3 => { 8i32 } _ => { v1 } })); let mut v15: f32 = (v9 * (2i32 as f32)); } if (1.375 >= pf) { return (if true { pf } else { 1.5 }); } (1.125 - v9) } else { let mut v16 = [v1, 2, 3]; let v17; if (true && pb) { v17 = ((pu << 2) as i32); } else { v17 = (4.5 as i32); } min(4.125, pf) })
}

#[kernel]
fn random_14(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    { let v1 = (if pb { Duo { n: pi, w: pv } } else { Duo { n: pi, w: Vec3::new(0.375, pf, 1.5) } });
    }let v2 = ((9u32).wrapping_add(pu) as i32);
    let mut v3: f32 = (0.0 - (pv).dot(pv));
    v3 += pf;
    v3
}

#[kernel]
fn random_15(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    { let mut v1 = { pu };
    let mut v2 = 0i32;
    loop { v2 += 1;
    if v2 > 5 { break;
    } { v1 = (v1 ^ (pi as u32));
    let v3 = ((pv).y as i32);
    } } v1 |= ((pu).wrapping_add(v1) << 2);
    }if { pb } { let mut v4 = helper((pu as i32), helper(pi, 1i32));
    match ({ let k = 6;
    k | pu }) { 0 | 1 => { v4 ^= (match (pb as i32) { -1 | 2 => { v4 } 3 => { v4 } _ => { pi } });
    let v5 = (match (v4 & 7i32) { -1 | 2 => { [v4, 2, 3] } 3 => { [v4, 2, 3] } _ => { [pi, 2, 3] } });
    if ((pf >= 3.5) || (pu == pu)) { v4 = ({ pb } as i32);
    let v6 = !(pv == Vec3::new(pf, pf, 1.5));
    } } 2 => { if (pv == pv) { return (if pb { 2.875 } else { 4.625 });
    } if pb { v4 = v4;
    v4 = ([v4, pi, pi])[((pu).wrapping_add(pu) % 3) as usize];
    v4 ^= v4;
    } let mut v7 = 0i32;
    loop { v7 += 1;
    if v7 > 5 { break;
    } { v4 ^= { v7 };
    } } } _ => { let mut v8 = [{ v4 }, (2.375 as i32), (pu as i32)];
    v4 ^= (Duo { w: pv, n: v4 }).n;
    for v9 in -2i32..=0 { v4 ^= { v9 };
    } } } } let mut v10 = (pi & 6i32);
    let v11: f32 = { pf };
    pf
}

#[kernel]
fn random_16(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = 0i32;
    loop { v1 += 1;
    if v1 > 5 { break;
    } { let v2 = match (pu as i32) { 1 => continue, 0 | 4 => (6i32 >> (pu & 7)), _ => { (match 1i32 { -1 | 2 => { v1 } 3 => { pi } _ => { 2i32 } }) } };
    if (({ let k = 6;
    k | 5u32 }) == (match v1 { -1 | 2 => { pu } 3 => { pu } _ => { pu } })) { match 1u32 { 0 | 1 => { let mut v3 = [(match v1 { -1 | 2 => { v1 } 3 => { v2 } _ => { pi } }), (5 ^ v1), 9i32];
    v3[1] = (!pb as i32);
    } 2 => { let mut v4 = (if !pb { pb } else { pb });
    } _ => { let v5 = ((pu as i32) as u32);
    } } let mut v6 = (Duo { w: Vec3::new(pf, pf, 1.5), n: pi }).w;
    } else { let mut v7 = [(match v1 { -1 | 2 => { 4i32 } 3 => { pi } _ => { v1 } }), v2, (pi).wrapping_mul(v2)];
    let v9 = match (if pb { pi } else { v2 }) { 1 => break, 0 | 4 => (pf * 4.125), _ => { v7[(((pu).wrapping_add(pu) << 2) % 3) as usize] ^= pi;
    let mut v8 = 0i32;
    while (pf >= pf) { v8 += 1;
    if v8 > 5 { break;
    } { v7[1] = ((pf + pf) as i32);
    } } (pf - pf) } };
    if { pb } { continue;
    } } let mut v10 = (if pb { false } else { pb });
    } } let mut v11 = { [pi, 2, 3] };
    let v12;
    if !pb { v12 = (if { pb } { 1i32 } else { pi });
    } else { v12 = (false as i32);
    } v11[((match (v11)[(pu % 3) as usize] { -1 | 2 => { pu } 3 => { pu } _ => { 5u32 } }) % 3) as usize] ^= ({ pu } as i32);
    (min(min(pf, pf), (6i32 as f32)) - pf)
}

#[kernel]
fn random_17(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if ((pf >= pf) && (pb ^ pb)) { let v1;
    if (1u32 == pu) { v1 = 4.875;
    } else { v1 = pf;
    } } else { if ((pb && pb) || (match pi { -1 | 2 => { pb } 3 => { pb } _ => { pb } })) { let v2 = Vec3::new((pf - pf), (pi as f32), (pv).dot(pv));
    if (if (true && true) { pb } else { pb }) { let mut v3 = (if (match pi { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { 3u32 } else { pu });
    v3 |= ((pi as u32)).wrapping_add((pi as u32));
    } else { let mut v4 = { pi };
    v4 = ((pu as i32)).wrapping_add((pi).wrapping_add(pi));
    v4 = (if (pf >= 3.125) { 0i32 } else { 3i32 });
    } } else { let mut v5 = ((7i32 & pi) >> ((pu).wrapping_add(pu) & 7));
    } } if { true } { let mut v6 = ((if pb { 9i32 } else { pi }) >> ((7u32 ^ pu) & 7));
    let mut v7 = Duo { n: pi, w: pv };
    let v8;
    if (1i32 < pi) { v8 = (Vec3::new(pf, 0.625, 3.625) + { Vec3::new(pf, pf, 1.5) });
    } else { v8 = (v7).w;
    } } match { 0u32 } { 0 | 1 => { let mut v9 = pi;
    for v10 in 0i32..0 { { v9 = ((pu as i32) >> ((4u32 ^ pu) & 7));
    }} if ({ pu } == (match 5i32 { -1 | 2 => { pu } 3 => { pu } _ => { pu } })) { for v11 in -1i32..3 { v9 = ((v9).wrapping_add(9i32)).wrapping_mul(v11);
    } let v12;
    if pb { v12 = ({ 4.375 } + (if false { pf } else { pf }));
    } else { v12 = min(pf, pf);
    } if (pv == (match 2i32 { -1 | 2 => { pv } 3 => { Vec3::new(pf, v12, 1.5) } _ => { Vec3::new(v12, pf, 1.5) } })) { v9 = ((v12 - 4.125) as i32);
    } } } 2 => { let mut v13 = { 1i32 };
    for v14 in -1i32..4 { let v15;
    if (pb ^ pb) { v15 = ((pu).wrapping_add(pu) as i32);
    } else { v15 = (pi).wrapping_add(pi);
    } } { v13 ^= (Duo { w: Vec3::new(pf, pf, 1.5), n: v13 }).n;
    let v16 = ((pu as i32) < ([v13, 2, 3])[(pu % 3) as usize]);
    }} _ => { { let mut v17 = ((if pb { pv } else { Vec3::new(pf, pf, 1.5) }) == (Duo { n: 0i32, w: pv }).w);
    let mut v18 = 0i32;
    while (match 4i32 { -1 | 2 => { v17 } 3 => { pb } _ => { false } }) { v18 += 1;
    if v18 > 5 { break;
    } { let v19;
    if (pf >= pf) { v19 = ({ v18 } as f32);
    } else { v19 = (pf + pf);
    } let mut v20 = Duo { w: pv, n: (match v18 { -1 | 2 => { v18 } 3 => { v18 } _ => { pi } }) };
    } } let mut v21 = (({ let k = 6;
    k | pu }) << 2);
    }let v22 = ((pu % 7) << 2);
    if ((pv == pv) || pb) { { let v23 = ((pv * 2.125) + Vec3::new(pf, pf, 1.5));
    }} } } let v24;
    if (pb ^ false) { v24 = (if (pv == Vec3::new(pf, pf, 1.5)) { Duo { n: 3i32, w: pv } } else { Duo { n: pi, w: pv } });
    } else { v24 = Duo { n: pi, ..Duo { n: pi, w: pv } };
    }
    (((pv).dot(pv) - (if pb { pf } else { pf })) + (pv).dot((match pi { -1 | 2 => { pv } 3 => { Vec3::new(3.125, 0.0, 1.5) } _ => { Vec3::new(1.5, 1.5, 1.5) } })))
}

#[kernel]
fn random_18(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if !(pb && pb) { let mut v1 = 0i32;
    while (match 8i32 { -1 | 2 => { false } 3 => { true } _ => { pb } }) { v1 += 1;
    if v1 > 5 { break;
    } { let mut v2 = (if { pb } { 4i32 } else { pi });
    if (if (pf >= pf) { false } else { pb }) { v2 = ((pf as i32)).wrapping_add((if pb { 7i32 } else { v2 }));
    v2 = { v2 };
    } } } let mut v3 = 0i32;
    while !pb { v3 += 1;
    if v3 > 5 { break;
    } { let mut v4 = 0i32;
    loop { v4 += 1;
    if v4 > 5 { break;
    } { let mut v5 = ((if false { 2i32 } else { v3 }) >> ((pu % 7) & 7));
    } } let mut v6 = ({ pv } + { pv });
    let mut v7 = (Duo { n: pi, w: v6 }).w;
    } } } { let mut v8 = pu;
    let mut v9 = helper({ 7i32 }, (pi).wrapping_mul(2i32));
    for v10 in 1i32..=2 { for v11 in -2i32..=0 { v9 ^= (pi).wrapping_mul((if pb { pi } else { v11 }));
    let v12;
    if { false } { v12 = (pi as f32);
    } else { v12 = (pf - pf);
    } let v13 = (match { v10 } { -1 | 2 => { Duo { n: v10, w: pv } } 3 => { Duo { n: v11, w: pv } } _ => { Duo { n: 3i32, w: pv } } });
    } if (pb || pb) { return (match v9 { -1 | 2 => { 3.0 } 3 => { pf } _ => { pf } });
    } if { pb } { v8 |= { v8 };
    v8 |= v8;
    v8 |= ((if pb { pi } else { 2i32 }) as u32);
    } else { v9 ^= (match helper(2i32, v9) { -1 | 2 => { 5i32 } 3 => { 9i32 } _ => { v10 } });
    v9 ^= ((pb ^ pb) as i32);
    v8 |= 0u32;
    } } }let v14 = ((Duo { n: 5i32, w: pv }).n).wrapping_add((if pb { pi } else { pi }));
    { let v15;
    if (pu == pu) { v15 = (match (Duo { n: v14, w: pv }).n { -1 | 2 => { [v14, 2, 3] } 3 => { [v14, 2, 3] } _ => { [6i32, 2, 3] } });
    } else { v15 = [8i32, pi, v14];
    } if pb { { let v16 = (Duo { n: v14, ..Duo { n: v14, w: pv } }).n;
    }} else { let mut v17 = { pi };
    let v18: f32 = min((v17 as f32), { 1.5 });
    let mut v19 = 0i32;
    loop { v19 += 1;
    if v19 > 5 { break;
    } { v17 ^= { 7i32 };
    let v20 = [v19, 2, 3];
    } } } }
    pf
}

#[kernel]
fn random_19(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = ((Vec3::new(pf, 2.75, 1.5) == Vec3::new(pf, pf, 1.5)) || (pb || pb));
    v1 = ((if false { pv } else { pv }) == (pv + pv));
    let mut v2 = [helper(pi, 1i32), (Duo { n: pi, w: pv }).n, (Duo { n: pi, w: Vec3::new(pf, pf, 1.5) }).n];
    v1 &= ((9i32 as f32) >= pf);
    min(((4i32 >> (pu & 7)) as f32), ((0.375 as i32) as f32))
}

#[kernel]
fn random_20(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = { pu };
    v1 = ((if pb { pu } else { v1 }) % 7);
    v1 = (pi as u32);
    { if ((v1 << 2) == (v1 << 2)) { if pb { v1 = (if (pb ^ pb) { v1 } else { v1 });
    } if (pb || pb) { return (0.625 - pf);
    } } else { for v2 in 1i32..1 { v1 |= ({ let k = 6;
    k | { pu } });
    let mut v3 = { [8i32, 2, 3] };
    v3[1] = ((3.75 - pf) as i32);
    } if ((v1 == pu) || (match pi { -1 | 2 => { pb } 3 => { false } _ => { pb } })) { v1 = ((9u32 ^ pu) ^ 6u32);
    v1 = (({ let k = 6;
    k | v1 }) ^ pu);
    let mut v4 = { Duo { n: pi, w: pv } };
    } if pb { v1 = (match pi { -1 | 2 => { 9u32 } 3 => { v1 } _ => { 1u32 } });
    v1 |= ((if pb { v1 } else { pu }) ^ { pu });
    } else { v1 |= (match (match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }) { -1 | 2 => { 7u32 } 3 => { 2u32 } _ => { pu } });
    } } }
    (min(pf, (pv).dot(pv)) - ((3i32 as f32) + (pv).y))
}

#[kernel]
fn random_21(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if ({ 5u32 } == (3i32 as u32)) { let mut v1 = Duo { w: (pv * pf), n: { 9i32 } };
    let v2 = [pi, 2, 3];
    } let mut v3 = ((2.5 as i32) as u32);
    v3 |= (pu ^ v3);
    v3 = ({ let k = 6;
    k | v3 });
    (4.875 - { 2.125 })
}

#[kernel]
fn random_22(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = (5 ^ ([pi, 2, 3])[(pu % 3) as usize]);
    let mut v2 = (pu).wrapping_add(pu);
    let mut v3: f32 = pf;
    match 8u32 { 0 | 1 => { if pb { if (true || pb) { return (3.125 * pf);
    } } } 2 => { v1 = (Duo { n: pi, w: Vec3::new(v3, pf, 1.5) }).n;
    { if { true } { v3 = ((Vec3::new(1.125, pf, 1.5)).dot(pv) + 4.5);
    v3 *= ((v3 - pf) + (pv).y);
    } else { v2 |= (match { v1 } { -1 | 2 => { pu } 3 => { pu } _ => { 7u32 } });
    } { v2 = ((v2 ^ pu) % 7);
    let mut v4 = [(7i32 >> (v2 & 7)), v1, (5 ^ v1)];
    }}} _ => { if { true } { { v2 |= ({ let k = 6;
    k | 0u32 });
    let mut v5 = Vec3::new(v3, 3.75, 1.5);
    v1 = ((match v1 { -1 | 2 => { 4u32 } 3 => { pu } _ => { v2 } }) as i32);
    }} if (if (pb && pb) { pb } else { pb }) { let v6 = { v1 };
    let mut v7: f32 = pf;
    } } }
    (6i32 as f32)
}

#[kernel]
fn random_23(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1 = ({ Duo { n: pi, w: pv } }).n;
    let mut v2: f32 = 3.5;
    { let mut v3 = [(pu as i32), (v1 & v1), (Duo { n: pi, w: Vec3::new(v2, 1.75, 1.5) }).n];
    v2 = ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { 4.75 } }) + { 0.625 });
    }v2 = { pf };
    min((0.75 * (v2 * v2)), ((v2 * pf) - (match pi { -1 | 2 => { v2 } 3 => { 3.125 } _ => { 0.625 } })))
}

#[kernel]
fn random_24(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1 = ([pi, 0i32, pi])[({ 4u32 } % 3) as usize];
    let v2;
    if (if pb { pb } else { pb }) { v2 = [(5 ^ 5i32), pi, (pi).wrapping_mul(pi)];
    } else { v2 = [pi, 2, 3];
    } let mut v3 = (if true { pb } else { true });
    if false { { let mut v4 = (if (pu == pu) { pv } else { pv });
    { v4.z += (v4).dot(Vec3::new(pf, pf, pf));
    v3 ^= v3;
    }}v3 = (if (1.375 >= pf) { v3 } else { true });
    } else { let mut v5 = ((if v3 { true } else { true }) ^ (true && pb));
    if (min(pf, pf) >= (pf + pf)) { v5 &= pb;
    } }
    min(((pv + Vec3::new(pf, pf, 1.5))).y, (if !pb { 4.375 } else { pf }))
}

#[kernel]
fn random_25(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1;
    if pb { v1 = (if (pi < pi) { [6i32, 2, 3] } else { [pi, 2, 3] });
    } else { v1 = [4i32, pi, 7i32];
    } if ((pv + Vec3::new(pf, 0.25, 1.5)) == (pv + Vec3::new(pf, pf, 1.5))) { if ({ pb } || (pb || pb)) { let mut v2 = pu;
    } else { let v3;
    if !pb { v3 = ((pu << 2) << 2);
    } else { v3 = pu;
    } } } else { match ({ let k = 6;
    k | pu }) { 0 | 1 => { { let v4 = { pb };
    let mut v5 = Duo { w: (pv + pv), n: (5 ^ pi) };
    v5.w.y = pf;
    }} 2 => { { let mut v6 = 4i32;
    }let mut v7 = [(if false { pi } else { pi }), pi, pi];
    match ({ let k = 6;
    k | pu }) { 0 | 1 => { let v8;
    if (match pi { -1 | 2 => { false } 3 => { pb } _ => { false } }) { v8 = Duo { w: (pv * pf), n: 8i32 };
    } else { v8 = (match pi { -1 | 2 => { Duo { n: pi, w: pv } } 3 => { Duo { n: 4i32, w: Vec3::new(pf, pf, 1.5) } } _ => { Duo { n: pi, w: pv } } });
    } v7[1] = pi;
    } 2 => { let v9;
    if (pf >= 1.25) { v9 = [(5 ^ pi), (0i32 >> (pu & 7)), (if pb { pi } else { pi })];
    } else { v9 = [pi, pi, pi];
    } let mut v10 = ((if true { pi } else { pi }) as u32);
    } _ => { v7[1] = { 0i32 };
    } } } _ => { let mut v11 = ((pu % 7)).wrapping_add({ pu });
    match (pu).wrapping_add(v11) { 0 | 1 => { let v12: f32 = ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { 2.75 } }) * (pi as f32));
    v11 |= ((match 6i32 { -1 | 2 => { 0u32 } 3 => { 7u32 } _ => { v11 } }) << 2);
    let v13 = ((v11 << 2) << 2);
    } 2 => { v11 |= 1u32;
    } _ => { v11 |= (0u32 % 7);
    v11 = (match (if pb { 1i32 } else { pi }) { -1 | 2 => { pu } 3 => { v11 } _ => { v11 } });
    let v14 = (({ let k = 6;
    k | v11 })).wrapping_add((v11 << 2));
    } } v11 |= { 3u32 };
    } } let mut v15 = 0i32;
    loop { v15 += 1;
    if v15 > 5 { break;
    } { let mut v16 = { pb };
    if v16 { v16 = !v16;
    } else { v16 ^= ((Duo { n: pi, w: pv }).w == (if v16 { Vec3::new(pf, 2.375, 1.5) } else { pv }));
    } let v17 = v16;
    } } } let mut v18 = { pb };
    { { for v19 in 1i32..=2 { v18 ^= ((match v19 { -1 | 2 => { pv } 3 => { pv } _ => { Vec3::new(pf, pf, 1.5) } }) == (Duo { n: pi, w: pv }).w);
    v18 = ((if v18 { pb } else { pb }) ^ v18);
    } let v20 = Duo { n: pi, ..Duo { n: pi, ..Duo { n: 6i32, w: Vec3::new(pf, pf, 1.5) } } };
    }if (pi < (if pb { pi } else { pi })) { match (pu % 7) { 0 | 1 => { v18 ^= v18;
    } 2 => { v18 &= (match 4i32 { -1 | 2 => { pb } 3 => { pb } _ => { v18 } });
    } _ => { v18 &= (if (pi < pi) { true } else { true });
    v18 &= true;
    v18 = v18;
    } } } else { let mut v21 = ((Duo { n: pi, w: pv }).n & (pi >> (0u32 & 7)));
    } }
    (((if pb { v18 } else { pb }) as i32) as f32)
}

#[kernel]
fn random_26(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if pb { return 1.125;
    } let mut v1 = [(false as i32), (pi >> (pu & 7)), (0i32).wrapping_mul(pi)];
    match 6u32 { 0 | 1 => { match (match pi { -1 | 2 => { pu } 3 => { pu } _ => { pu } }) { 0 | 1 => { if ((pu).wrapping_add(pu) == pu) { v1[(((8u32).wrapping_add(pu)).wrapping_add((if pb { pu } else { pu })) % 3) as usize] ^= ((if false { pi } else { 5i32 }) >> (({ let k = 6;
    k | pu }) & 7));
    v1 = [(pi >> (5u32 & 7)), 1i32, pi];
    } else { v1 = v1;
    } let v2;
    if (pu == pu) { v2 = ((4.125 - pf) * (pi as f32));
    } else { v2 = (if pb { pf } else { pf });
    } } 2 => { { v1 = [(3.0 as i32), (pi >> (pu & 7)), (match pi { -1 | 2 => { pi } 3 => { pi } _ => { 3i32 } })];
    let v3;
    if (pi < pi) { v3 = { pu };
    } else { v3 = (pu).wrapping_add(pu);
    } }} _ => { for v4 in -2i32..=0 { let v5 = (if pb { Duo { n: v4, w: pv } } else { Duo { n: v4, w: pv } });
    v1[1] = pi;
    } if ((7u32 << 2) == (9u32 ^ pu)) { let mut v6 = ((if false { Duo { n: pi, w: pv } } else { Duo { n: pi, w: Vec3::new(pf, pf, 1.5) } })).w;
    v1 = v1;
    v1[((helper(pi, pi) as u32) % 3) as usize] ^= ((match pi { -1 | 2 => { 1i32 } 3 => { pi } _ => { pi } })).wrapping_add((3.125 as i32));
    } } } let v7 = (if pb { pu } else { pu });
    } 2 => { let mut v8 = Duo { w: pv, n: (pb as i32) };
    for v9 in 0i32..4 { if (pf >= (5i32 as f32)) { let mut v10 = { v1 };
    } else { v1 = [6i32, { v9 }, (match pi { -1 | 2 => { pi } 3 => { v9 } _ => { pi } })];
    v8.w.y = ((Vec3::new(pf, pf, 1.5) + pv)).dot((if pb { pv } else { pv }));
    } let mut v11: f32 = (match (if pb { v9 } else { 9i32 }) { -1 | 2 => { pf } 3 => { 2.375 } _ => { pf } });
    let mut v12 = 0i32;
    while !true { v12 += 1;
    if v12 > 5 { break;
    } { v8 = Duo { w: Vec3::new(v11, v11, pf), n: (v12).wrapping_mul(pi) };
    v8 = Duo { n: (4i32 & v9), ..Duo { w: pv, n: 6i32 } };
    let v13: f32 = ((v11 + 3.375) * (pv).dot(pv));
    } } } v1 = [(pi).wrapping_mul(pi), { pi }, (1.375 as i32)];
    } _ => { let v14;
    if (if true { pb } else { false }) { v14 = [pi, (pf as i32), (if true { pi } else { pi })];
    } else { v14 = [pi, 8i32, 0i32];
    } } } let v15 = (!pb && pb);
    (((pi as f32) * (if false { pf } else { 2.5 })) + ((pv * pf)).y)
}

#[kernel]
fn random_27(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    match (pi as u32) { 0 | 1 => { for v1 in -1i32..2 { let v2 = (({ let k = 6;
    k | pu })).wrapping_add(pu);
    if ((if pb { pi } else { pi }) < (Duo { n: 2i32, w: Vec3::new(pf, 0.75, 1.5) }).n) { let v3 = Vec3::new((v1 as f32), { pf }, (if false { pf } else { pf }));
    let mut v4: f32 = (if !true { 2.875 } else { pf });
    v4 *= ((pf - 4.625) * pf);
    } else { let mut v5 = v2;
    v5 = ((v2 % 7) % 7);
    } } match (5i32 as u32) { 0 | 1 => { match (pi as u32) { 0 | 1 => { let v6 = pb;
    } 2 => { let v7 = pb;
    let v8;
    if (v7 && v7) { v8 = { pi };
    } else { v8 = (if v7 { pi } else { pi });
    } let mut v9 = pv;
    } _ => { let mut v10: f32 = pf;
    v10 *= min((pv).dot(pv), (match pi { -1 | 2 => { pf } 3 => { 3.75 } _ => { v10 } }));
    } } match (pu % 7) { 0 | 1 => { let v11;
    if (if pb { pb } else { true }) { v11 = ((if pb { pv } else { pv })).dot((Vec3::new(4.375, pf, 1.5) * pf));
    } else { v11 = 1.0;
    } } 2 => { let v12: f32 = ((pv + pv)).dot((match pi { -1 | 2 => { pv } 3 => { Vec3::new(pf, pf, 1.5) } _ => { pv } }));
    } _ => { let mut v13: f32 = (match (match 2i32 { -1 | 2 => { pi } 3 => { pi } _ => { pi } }) { -1 | 2 => { pf } 3 => { pf } _ => { pf } });
    let mut v14 = (Duo { w: pv, n: 8i32 }).w;
    } } match (pi as u32) { 0 | 1 => { let v15;
    if (pu == pu) { v15 = (match (pi).wrapping_add(2i32) { -1 | 2 => { pu } 3 => { pu } _ => { 3u32 } });
    } else { v15 = pu;
    } let v16 = (match pi { -1 | 2 => { pb } 3 => { pb } _ => { false } });
    let mut v17 = (if (pb && v16) { [5i32, 2, 3] } else { [pi, 2, 3] });
    } 2 => { let mut v18 = Duo { n: (match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }), ..(if true { Duo { n: pi, w: pv } } else { Duo { n: pi, w: pv } }) };
    } _ => { let mut v19 = (({ let k = 6;
    k | pu })).wrapping_add((match pi { -1 | 2 => { 9u32 } 3 => { 5u32 } _ => { pu } }));
    let mut v20 = Duo { w: (match pi { -1 | 2 => { Vec3::new(pf, pf, 1.5) } 3 => { pv } _ => { pv } }), n: (pb as i32) };
    } } } 2 => { match pu { 0 | 1 => { let v21;
    if (if pb { pb } else { pb }) { v21 = ((pu as i32) >> ({ pu } & 7));
    } else { v21 = (Duo { n: pi, w: pv }).n;
    } let mut v22 = { pb };
    let v23;
    if (pu == pu) { v23 = (Vec3::new(3.875, pf, pf) == (pv + pv));
    } else { v23 = !false;
    } } 2 => { let mut v24: f32 = ((Duo { n: pi, w: Vec3::new(pf, 4.75, 1.5) }).w).dot((Duo { n: 3i32, w: pv }).w);
    v24 = ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { pf } }) - (if false { pf } else { pf }));
    v24 += ((pv + pv)).dot((pv + pv));
    } _ => { let mut v25 = ((pu as i32) & (5 ^ pi));
    } } for v26 in -1i32..=0 { let v27;
    if pb { v27 = !(pu == pu);
    } else { v27 = (pb ^ false);
    } } let mut v28: f32 = min((8i32 as f32), (match 5i32 { -1 | 2 => { pf } 3 => { 3.375 } _ => { pf } }));
    } _ => { let mut v29 = 0i32;
    loop { v29 += 1;
    if v29 > 5 { break;
    } { let mut v30 = (if (pb ^ pb) { false } else { pb });
    v30 ^= (match 0i32 { -1 | 2 => { false } 3 => { true } _ => { false } });
    v30 &= (Vec3::new(1.0, 3.875, pf) == (if v30 { Vec3::new(1.0, pf, 1.5) } else { pv }));
    } } } } } 2 => { let mut v31 = Duo { n: helper(pi, pi), ..Duo { n: 1i32, ..Duo { n: pi, w: pv } } };
    v31.w.y = (if (1.875 >= pf) { pf } else { pf });
    } _ => { let mut v32 = Duo { n: (if false { pi } else { pi }), ..Duo { w: Vec3::new(pf, pf, 1.5), n: pi } };
    v32.n = (5 ^ helper(pi, pi));
    } } let mut v33 = ((pv + pv) * (1.0 * pf));
    if ((2i32 as f32) >= min(1.625, pf)) { v33 = ((if pb { Duo { n: pi, w: pv } } else { Duo { n: 3i32, w: Vec3::new(pf, pf, 1.5) } })).w;
    } else { let mut v34 = { 8i32 };
    } v33.x = ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { pf } }) + (pf + pf));
    (pv).y
}

#[kernel]
fn random_28(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    for v1 in -2i32..4 { let mut v2 = ({ pu }).wrapping_add((2i32 as u32));
    { v2 = { pu };
    v2 |= ((3u32 ^ 3u32) % 7);
    if ((if true { 3i32 } else { v1 }) < { 9i32 }) { v2 = v2;
    let mut v3 = ([pi, v1, 1i32])[(8u32 % 3) as usize];
    } }} let mut v4 = [(pb as i32), (if false { pi } else { pi }), { 9i32 }];
    let mut v5: f32 = ((2i32 >> (pu & 7)) as f32);
    v4[((4i32 as u32) % 3) as usize] ^= pi;
    pf
}

#[kernel]
fn random_29(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if { pb } { let mut v1 = [{ pi }, (pi).wrapping_mul(pi), (pi).wrapping_add(pi)];
    } let mut v2: f32 = (if (pf >= 1.5) { pf } else { pf });
    v2 += (if (pi < 6i32) { v2 } else { v2 });
    v2 *= (Vec3::new(v2, 3.125, v2)).dot((match pi { -1 | 2 => { pv } 3 => { pv } _ => { Vec3::new(v2, v2, 1.5) } }));
    ((match (match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }) { -1 | 2 => { 0.625 } 3 => { 2.125 } _ => { pf } }) + (if pb { v2 } else { 3.0 }))
}

#[kernel]
fn random_30(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1 = ((pu as i32) as u32);
    let v2: f32 = 1.875;
    for v3 in -1i32..1 { for v4 in -1i32..3 { let mut v5 = [([v3, 2, 3])[(pu % 3) as usize], (pi).wrapping_add(v4), (5 ^ 7i32)];
    v5 = [(pb as i32), (pi >> (pu & 7)), v4];
    } let v6;
    if (v2 >= v2) { v6 = pv;
    } else { v6 = (if true { pv } else { pv });
    } } let v7 = [(pi & pi), (pi >> (6u32 & 7)), ([pi, 2, 3])[(v1 % 3) as usize]];
    (match ((v2 as i32)).wrapping_mul((if pb { pi } else { pi })) { -1 | 2 => { (Vec3::new(pf, v2, 1.5)).dot(pv) } 3 => { let mut v8 = 0i32; loop { v8 += 1; if v8 > 5 { break; } { let v9 = (match helper(7i32, pi) { -1 | 2 => { pb } 3 => { pb } _ => { pb } }); let mut v10 = Duo { n: (pu as i32), ..Duo { n: 0i32, w: pv } }; } } pf } _ => { (pv).dot(pv) } })
}

#[kernel]
fn random_31(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = ((match 4i32 { -1 | 2 => { pu } 3 => { 3u32 } _ => { 6u32 } })).wrapping_add((pu << 2));
    let mut v2: f32 = pf;
    if { pb } { return (pv).dot(pv);
    } if ((Vec3::new(pf, 4.625, 1.5) == pv) && (pu == 0u32)) { { let mut v3 = (Duo { w: pv, n: 7i32 }).n;
    let v4 = (if (pu == v1) { Duo { n: pi, w: pv } } else { Duo { n: v3, w: pv } });
    if (pb && pb) { return (pv).dot(Vec3::new(4.375, v2, 1.5));
    } }}
    ({ v2 } - ({ 1i32 } as f32))
}

#[kernel]
fn random_32(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = (pi).wrapping_add((match pi { -1 | 2 => { pi } 3 => { pi } _ => { 7i32 } }));
    v1 ^= ((pu).wrapping_add(pu) as i32);
    v1 ^= ((pu == pu) as i32);
    if ((3u32).wrapping_add(pu) == pu) { if (pu == { pu }) { v1 = (if (if pb { pb } else { pb }) { 6i32 } else { 1i32 });
    if (pb ^ pb) { return pf;
    } let v2;
    if (pb && pb) { v2 = 7u32;
    } else { v2 = pu;
    } } }
    (if pb { if ((1.375 >= pf) || (pb ^ pb)) { v1 ^= ((Duo { n: 2i32, w: pv }).n).wrapping_add((pi).wrapping_mul(4i32)); v1 = (match (pf as i32) { -1 | 2 => { pi } 3 => { v1 } _ => { pi } }); v1 = (match (match v1 { -1 | 2 => { 7i32 } 3 => { pi } _ => { pi } }) { -1 | 2 => { 3i32 } 3 => { pi } _ => { pi } }); } pf } else { { v1 = pi; let mut v3 = Duo { w: pv, n: (v1).wrapping_add(2i32) }; }if (if (if pb { false } else { false }) { pb } else { true }) { v1 ^= ((pv).y as i32); let mut v4 = ((pb as i32) & v1); } (v1 as f32) })
}

#[kernel]
fn random_33(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = { pi };
    v1 ^= { v1 };
    let mut v2 = 0i32;
    while !pb { v2 += 1;
    if v2 > 5 { break;
    } { let v4 = match (match v1 { -1 | 2 => { 4i32 } 3 => { 4i32 } _ => { v1 } }) { 1 => break, 0 | 4 => (Duo { n: 4i32, w: pv }).w, _ => { match (v1 as u32) { 0 | 1 => { let v3 = Vec3::new(pf, pf, 1.5);
    } 2 => { v1 = (match (match 9i32 { -1 | 2 => { v1 } 3 => { v2 } _ => { v2 } }) { -1 | 2 => { 0i32 } 3 => { 1i32 } _ => { v1 } });
    v1 = ((if true { pi } else { 1i32 }) >> ((9i32 as u32) & 7));
    } _ => { v1 = (match pi { -1 | 2 => { pi } 3 => { v1 } _ => { v2 } });
    } } (Duo { n: pi, w: Vec3::new(pf, pf, 1.5) }).w } };
    for v5 in 0i32..=0 { match (pi).wrapping_mul(v2) { 0 => return 1.5, 2 | 3 => { let v6;
    if pb { v6 = (match (pf as i32) { -1 | 2 => { Vec3::new(4.375, 4.25, 1.5) } 3 => { pv } _ => { v4 } });
    } else { v6 = (v4 * pf);
    } v1 ^= (if pb { v1 } else { pi });
    v1 ^= v1;
    } _ => {} } } match (match v2 { -1 | 2 => { v1 } 3 => { pi } _ => { pi } }) { 0 => continue, 2 | 3 => { { v1 = ([v2, 3i32, 8i32])[((pu % 7) % 3) as usize];
    }v1 ^= ((v2 >> (pu & 7)) >> ((pu % 7) & 7));
    let mut v7 = (({ let k = 6;
    k | pu }) as i32);
    } _ => {} } } } v1 ^= ((match 8i32 { -1 | 2 => { v1 } 3 => { pi } _ => { 7i32 } })).wrapping_mul(helper(v1, pi));
    ((7i32 as f32) - (pf - pf))
}

#[kernel]
fn random_34(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if (match pi { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { return pf;
    } { let v1;
    if (pu == pu) { v1 = Duo { n: pi, w: pv };
    } else { v1 = Duo { w: pv, n: pi };
    } let v2: f32 = (Vec3::new(4.875, pf, 1.375)).y;
    }if pb { let mut v3 = (Duo { n: pi, w: Vec3::new(3.625, pf, 1.5) }).w;
    { if !pb { return (Vec3::new(1.75, pf, 1.5)).y;
    } v3.x = min(0.125, (Vec3::new(pf, pf, 1.5)).y);
    }v3.z += (pi as f32);
    } else { for v4 in -2i32..4 { let mut v5 = 0i32;
    loop { v5 += 1;
    if v5 > 5 { break;
    } { let v6;
    if (pb && pb) { v6 = Duo { n: 6i32, w: pv };
    } else { v6 = Duo { w: Vec3::new(pf, pf, 1.5), n: 0i32 };
    } } } } } let mut v7: f32 = ((pi as f32) + min(4.75, pf));
    ((helper(0i32, 1i32) & (7i32).wrapping_add(pi)) as f32)
}

#[kernel]
fn random_35(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    { let mut v1: f32 = (pv).y;
    let v2 = Vec3::new(pf, v1, 1.5);
    if (false ^ pb) { return (if pb { 1.25 } else { v1 });
    } }let v3;
    if (if pb { pb } else { pb }) { v3 = pv;
    } else { v3 = { pv };
    } for v4 in -1i32..3 { let v6 = match (4i32).wrapping_mul(v4) { 1 => break, 0 | 4 => v4, _ => { let mut v5 = Vec3::new((v3).dot(pv), { 1.75 }, (pf * pf));
    if (pb && pb) { return 1.5;
    } (Duo { n: v4, w: v5 }).n } };
    } let v7;
    if (3.25 >= pf) { v7 = { pf };
    } else { v7 = min(0.125, pf);
    }
    { min(pf, pf) }
}

#[kernel]
fn random_36(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = 0i32;
    loop { v1 += 1;
    if v1 > 5 { break;
    } { let mut v2 = (if (pi < v1) { pi } else { pi });
    match (3u32 % 7) { 0 | 1 => { let v3;
    if true { v3 = (match (if pb { 9i32 } else { v2 }) { -1 | 2 => { pb } 3 => { true } _ => { false } });
    } else { v3 = (pu == 8u32);
    } } 2 => { let mut v4: f32 = { pf };
    } _ => { let v5 = Vec3::new((pf + pf), (Vec3::new(pf, pf, 1.5)).y, (3.375 * pf));
    } } { if (false && pb) { return (8i32 as f32);
    } match (if pb { v2 } else { pi }) { 0 => return 1.5, 2 | 3 => { v2 = v2;
    v2 ^= ((Duo { n: 0i32, w: pv }).n >> ((7i32 as u32) & 7));
    } _ => {} } let mut v6 = [v1, 2, 3];
    }} } if ((pv).y >= min(pf, pf)) { if (match pi { -1 | 2 => { true } 3 => { pb } _ => { pb } }) { return (pf - pf);
    } } if (!pb && (pi < pi)) { let v7;
    if (match pi { -1 | 2 => { pb } 3 => { pb } _ => { false } }) { v7 = ((pf * 1.875) + (Vec3::new(pf, 2.125, 1.5)).y);
    } else { v7 = pf;
    } let v8;
    if (pb ^ pb) { v8 = ((true || pb) ^ (v7 >= v7));
    } else { v8 = (pi < pi);
    } } let mut v9 = 0i32;
    while (8i32 < pi) { v9 += 1;
    if v9 > 5 { break;
    } { let mut v10 = pv;
    } }
    pf
}

#[kernel]
fn random_37(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    if (pb && (pf >= pf)) { let mut v1 = (if (pb && pb) { pb } else { pb });
    } if ((false ^ pb) ^ (pi < pi)) { let v2 = Duo { n: pi, w: pv };
    let v3;
    if (pb && false) { v3 = ((8u32 << 2) << 2);
    } else { v3 = { pu };
    } let mut v4 = Vec3::new(pf, 1.875, 1.5);
    } let mut v5 = Duo { n: 9i32, w: pv };
    if (match (Duo { n: pi, w: pv }).n { -1 | 2 => { pb } 3 => { pb } _ => { pb } }) { let mut v6 = [(pi >> (pu & 7)), (pi).wrapping_mul(3i32), { 1i32 }];
    for v7 in 1i32..=1 { if pb { return (pv).y;
    } match (3.75 as i32) { 0 => return 1.5, 2 | 3 => { v6 = [(if pb { 6i32 } else { v7 }), v7, v7];
    } _ => {} } } { let v8: f32 = { pf };
    v6 = (match (if false { pi } else { pi }) { -1 | 2 => { v6 } 3 => { v6 } _ => { v6 } });
    if ((match 6i32 { -1 | 2 => { false } 3 => { false } _ => { pb } }) ^ pb) { let v9;
    if (match pi { -1 | 2 => { pb } 3 => { false } _ => { pb } }) { v9 = Duo { n: (match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }), ..Duo { w: pv, n: 6i32 } };
    } else { v9 = Duo { n: 5i32, ..v5 };
    } v6 = [(v8 as i32), (if true { 6i32 } else { pi }), ([8i32, 2, 3])[(pu % 3) as usize]];
    v5 = v5;
    } }}
    (((match pi { -1 | 2 => { pi } 3 => { pi } _ => { pi } }) as f32) * ((match pi { -1 | 2 => { pf } 3 => { pf } _ => { pf } }) * (pf - pf)))
}

#[kernel]
fn random_38(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let v1 = pb;
    let mut v2 = { pb };
    { if !(pu == 8u32) { let mut v3 = ({ let k = 6;
    k | (if v1 { 7u32 } else { pu }) });
    } let mut v4 = Duo { n: 3i32, w: pv };
    { v2 = v2;
    }}let v5: f32 = ((pf * pf) * pf);
    { { v2 &= ((match pi { -1 | 2 => { pv } 3 => { Vec3::new(pf, 1.5, 1.5) } _ => { pv } }) == (Duo { n: 2i32, w: Vec3::new(pf, v5, 1.5) }).w); let mut v6 = (pv == (pv + pv)); v6 &= (match { pi } { -1 | 2 => { v2 } 3 => { false } _ => { v2 } }); }{ v2 ^= ((if v1 { pu } else { pu }) == (pu % 7)); }(pf - v5) }
}

#[kernel]
fn random_39(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {
    let mut v1 = pb;
    let v2;
    if (pf >= pf) { v2 = ({ pi } >> ((pu).wrapping_add(5u32) & 7));
    } else { v2 = pi;
    } let mut v3 = (if !false { Duo { n: v2, w: pv } } else { Duo { n: v2, w: pv } });
    v3.w.y = ((Duo { n: 0i32, w: pv }).n as f32);
    pf
}

#[test]
fn random_kernels_mean_what_rust_means() {
    agrees(kernels![random_0][0]);
    agrees(kernels![random_1][0]);
    agrees(kernels![random_2][0]);
    agrees(kernels![random_3][0]);
    agrees(kernels![random_4][0]);
    agrees(kernels![random_5][0]);
    agrees(kernels![random_6][0]);
    agrees(kernels![random_7][0]);
    agrees(kernels![random_8][0]);
    agrees(kernels![random_9][0]);
    agrees(kernels![random_10][0]);
    agrees(kernels![random_11][0]);
    agrees(kernels![random_12][0]);
    agrees(kernels![random_13][0]);
    agrees(kernels![random_14][0]);
    agrees(kernels![random_15][0]);
    agrees(kernels![random_16][0]);
    agrees(kernels![random_17][0]);
    agrees(kernels![random_18][0]);
    agrees(kernels![random_19][0]);
    agrees(kernels![random_20][0]);
    agrees(kernels![random_21][0]);
    agrees(kernels![random_22][0]);
    agrees(kernels![random_23][0]);
    agrees(kernels![random_24][0]);
    agrees(kernels![random_25][0]);
    agrees(kernels![random_26][0]);
    agrees(kernels![random_27][0]);
    agrees(kernels![random_28][0]);
    agrees(kernels![random_29][0]);
    agrees(kernels![random_30][0]);
    agrees(kernels![random_31][0]);
    agrees(kernels![random_32][0]);
    agrees(kernels![random_33][0]);
    agrees(kernels![random_34][0]);
    agrees(kernels![random_35][0]);
    agrees(kernels![random_36][0]);
    agrees(kernels![random_37][0]);
    agrees(kernels![random_38][0]);
    agrees(kernels![random_39][0]);
}
