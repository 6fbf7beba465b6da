//! Measures how many equal pictures of 256 by 256 pixels are judged in a second: in memory, and with the files read and
//! decoded.

use lobe_golden::image::{read_golden, read_picture, write_golden};
use lobe_golden::{Golden, GoldenError};
use std::time::Instant;

const SIDE: u32 = 256;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = 3 * (SIDE * SIDE) as usize;
    let truth: Vec<f64> = (0..count).map(|at| (at as f64 * 0.001).sin().abs()).collect();
    let golden = Golden::new([SIDE, SIDE], &truth, &vec![1e-6; count])?;
    let picture = golden.truth().to_vec();
    let mut other = picture.clone();
    other[count / 2] += 1e-7;
    let judge =
        |picture: &[f32]| golden.judge([SIDE, SIDE], picture).map(|verdict| assert!(verdict.passes()));
    rate("equal, in memory", 2000, || judge(&picture))?;
    rate("one value apart, in memory", 200, || judge(&other))?;
    let bytes = write_golden(&golden)?;
    let from_files = || -> Result<(), Box<dyn std::error::Error>> {
        let (golden, picture) = (read_golden(&bytes)?, read_picture(&bytes)?);
        golden.judge(picture.size, &picture.values)?;
        Ok(())
    };
    let begin = Instant::now();
    (0..50).try_for_each(|_| from_files())?;
    println!("{:32} {:8.0} a second", "equal, both decoded", 50.0 / begin.elapsed().as_secs_f64());
    Ok(())
}

fn rate(name: &str, rounds: u32, act: impl Fn() -> Result<(), GoldenError>) -> Result<(), GoldenError> {
    let begin = Instant::now();
    (0..rounds).try_for_each(|_| act())?;
    println!("{name:32} {:8.0} a second", f64::from(rounds) / begin.elapsed().as_secs_f64());
    Ok(())
}
