// A 16.16 multiply in Rust that rounds halves to even: reads cases, writes results.
use std::io::{stdin, stdout, BufWriter, Write};

fn mul(a: i32, b: i32) -> i32 {
    let product = i64::from(a) * i64::from(b);
    let (whole, rest) = (product >> 16, product & 0xffff);
    let up = rest > 0x8000 || (rest == 0x8000 && whole & 1 == 1);
    (whole + i64::from(up)) as i32
}

fn main() {
    let mut out = BufWriter::new(stdout());
    for line in stdin().lines().map(Result::unwrap) {
        let (a, b) = line.split_once(' ').unwrap();
        let word = |text| u32::from_str_radix(text, 16).unwrap() as i32;
        writeln!(out, "{:08x}", mul(word(a), word(b))).unwrap();
    }
}
