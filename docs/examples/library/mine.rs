// Functions for `fixproof verify --against ./libmine.so:NAME`: 16.16, half up, wrapping.

/// A product has 32 fraction bits. The half that is added is worth 2^-17, half a unit of 16.16.
#[no_mangle]
pub extern "C" fn my_mul(a: i32, b: i32) -> i32 {
    ((i64::from(a) * i64::from(b) + 0x8000) >> 16) as i32
}

/// The same for arrays.
///
/// # Safety
/// All three pointers must lead to `count` words, and `result` to none of the operands.
#[no_mangle]
pub unsafe extern "C" fn my_muls(a: *const i32, b: *const i32, result: *mut i32, count: usize) {
    let a = std::slice::from_raw_parts(a, count);
    let b = std::slice::from_raw_parts(b, count);
    let result = std::slice::from_raw_parts_mut(result, count);
    for ((to, &a), &b) in result.iter_mut().zip(a).zip(b) {
        *to = my_mul(a, b);
    }
}

/// Wrong: it rounds down.
#[no_mangle]
pub extern "C" fn my_mul_down(a: i32, b: i32) -> i32 {
    ((i64::from(a) * i64::from(b)) >> 16) as i32
}
