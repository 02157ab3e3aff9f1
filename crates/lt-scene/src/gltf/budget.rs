//! A ceiling on how much a small file may unfold to.
//!
//! Indices, accessors and meshes can be shared any number of times in glTF, so that a file of a few kilobytes can
//! describe more vertices than there is memory. Every copy that an importer makes is charged here first.

use super::fault::Fault;

/// Elements (corners, vertices, keyframe values, instances) always granted: 2²⁶, a gigabyte or so.
const FLOOR: u64 = 1 << 26;
/// Elements granted per byte of buffers.
const PER_BYTE: u64 = 16;

/// Elements that may still be made.
#[derive(Clone, Debug)]
pub(super) struct Budget {
    granted: u64,
    left: u64,
}

impl Budget {
    /// For an asset with this many bytes of buffers.
    pub(super) fn for_bytes(bytes: usize) -> Self {
        let granted = (bytes as u64).saturating_mul(PER_BYTE).max(FLOOR);
        Self { granted, left: granted }
    }

    /// Takes `amount` elements, or says at `place` that they are too many.
    pub(super) fn charge(&mut self, amount: u64, place: impl FnOnce() -> String) -> Result<(), Fault> {
        match self.left.checked_sub(amount) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(Fault::at(
                place(),
                format!(
                    "needs {amount} more elements when {} of the {} that a file of this size may unfold to are \
                     left; the file is broken, or shares its data too often: split it",
                    self.left, self.granted
                ),
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_spent_is_not_granted_again() {
        let mut budget = Budget::for_bytes(0);
        assert!(budget.charge(FLOOR - 1, String::new).is_ok());
        assert!(budget.charge(2, String::new).is_err());
        assert!(budget.charge(1, String::new).is_ok());
        assert!(budget.charge(1, String::new).is_err());
        assert!(budget.charge(u64::MAX, String::new).is_err());
    }
}
