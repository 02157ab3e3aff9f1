//! What a packet has still to visit in a tree: a stack, and a ring in which nodes wait for their data.
//!
//! A node that few rays reach takes less time to test than to fetch from memory. So it is asked for when it leaves the stack,
//! and tested only after [`RING`] others of its kind have left it.

use super::tree::ROOT;
use crate::ray::NONE;
use crate::traverse::MAX_DEPTH;

/// So few rays wait for data, and are tested one by one.
const FEW: u32 = 12;
/// Places in the ring.
const RING: usize = 8;
/// Siblings that may be on the stack. Between a family and that of its parent lie at most those that were pushed while the
/// parent was in the ring, so that there are at most [`RING`] families for each level.
const STACK: usize = 8 * RING * MAX_DEPTH + 1;

/// A link, and what reached it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Visit {
    pub link: u32,
    /// Whether the rays are to be tested one by one.
    pub is_spread: bool,
    /// Mask of the rays.
    pub rays: u64,
}

const NOBODY: Visit = Visit { link: ROOT, is_spread: false, rays: 0 };

/// A packet's way through one tree.
pub(crate) struct Walk {
    stack: [Visit; STACK],
    len: usize,
    /// Being fetched; without rays where a place is free.
    ring: [Visit; RING],
    /// Whose turn it is.
    turn: usize,
    /// Places taken.
    taken: usize,
    /// The leaf that blocked rays of the last packet, if any were: its neighbour's rays likely end there too.
    pub blocker: u32,
}

impl Walk {
    pub fn new() -> Self {
        Walk { stack: [NOBODY; STACK], len: 0, ring: [NOBODY; RING], turn: 0, taken: 0, blocker: NONE }
    }

    /// Adds what is to be visited by at least one ray.
    #[inline(always)]
    pub fn push(&mut self, visit: Visit) {
        self.stack[self.len] = visit;
        self.len += 1;
    }

    /// What to visit next, by those of its rays that are still `alive`; `fetch` starts to fetch what a link leads to.
    #[inline(always)]
    pub fn next(&mut self, alive: u64, fetch: impl Fn(u32)) -> Option<Visit> {
        while self.len + self.taken > 0 {
            let mut visit = NOBODY;
            if self.len > 0 {
                self.len -= 1;
                visit = self.stack[self.len];
                visit.rays &= alive;
                if visit.rays == 0 {
                    continue;
                }
                if !visit.is_spread && visit.rays.count_ones() > FEW {
                    return Some(visit);
                }
                visit.is_spread = true;
                fetch(visit.link);
                self.taken += 1;
            }
            let mut ready = core::mem::replace(&mut self.ring[self.turn], visit);
            self.turn = (self.turn + 1) % RING;
            self.taken -= usize::from(ready.rays != 0);
            ready.rays &= alive;
            if ready.rays != 0 {
                return Some(ready);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Visits a tree in which every node above `depth` has eight children that all `rays` reach, of at most `most` nodes;
    /// how many it had. The link is the level.
    fn visit_all(depth: usize, rays: u64, most: usize) -> usize {
        let mut walk = Walk::new();
        let mut visits = 0;
        walk.push(Visit { link: 1, is_spread: false, rays });
        while let Some(visit) = walk.next(u64::MAX, |_| ()) {
            visits += 1;
            if (visit.link as usize) < depth && visits < most {
                (0..8).for_each(|_| walk.push(Visit { link: visit.link + 1, ..visit }));
            }
        }
        assert_eq!((walk.len, walk.taken), (0, 0));
        visits
    }

    #[test]
    fn every_link_is_visited_once() {
        for rays in [1, 0xff, u64::MAX] {
            assert_eq!(visit_all(6, rays, usize::MAX), (0..6).map(|level| 8usize.pow(level)).sum());
        }
    }

    #[test]
    fn stack_holds_the_deepest_tree_while_nodes_wait() {
        for rays in [1, u64::MAX] {
            assert!(visit_all(MAX_DEPTH, rays, 100_000) >= 100_000);
        }
    }

    #[test]
    fn who_is_dead_is_not_visited() {
        let mut walk = Walk::new();
        for rays in [0b01, 0b10, 0b11] {
            walk.push(Visit { link: 7, is_spread: false, rays });
        }
        let mut seen = 0;
        while let Some(visit) = walk.next(0b10, |_| ()) {
            assert_eq!(visit.rays, 0b10);
            seen += 1;
        }
        assert_eq!(seen, 2);
    }
}
