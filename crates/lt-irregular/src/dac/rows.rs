//! Arrays that hold lists row by row.

use alloc::vec::Vec;

/// Room behind every list, so that whole registers may be written at its end.
pub(super) const SLACK: usize = 16;

/// Makes a row longer. The first time it comes zeroed from the system, untouched.
pub(super) fn grow<T: Copy>(row: &mut Vec<T>, len: usize, zero: T) {
    if row.is_empty() {
        *row = alloc::vec![zero; len];
    } else {
        row.resize(len, zero);
    }
}
