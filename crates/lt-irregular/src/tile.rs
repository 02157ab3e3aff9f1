//! Up to 64 neighbouring points through a tree together, under one rectangle: few steps where casters are larger than tiles.

use crate::block::{ASKS, Block, NOBODY, Spread};
use crate::casters::Query;
use crate::exact::Exact;
use crate::rect::Rect;
use crate::tree::{LEAF, Tree};
use crate::view::View;
use crate::walk::walk_one;
use lt_bvh::lanes::{Lanes, NodeLanes};
use lt_bvh::{AnyHit, permute};
use lt_math::glam::Vec3;

/// Points to a tile.
pub(crate) const TILE: usize = 64;
/// Links that a walk may have waiting: seven at each lanes.
const STACK: usize = 256;
/// Up to this many points are looked at one by one.
const FEW: u32 = 3;
/// Links that wait for their data before few points are held against them.
const RING: usize = 8;
/// Triangles that wait for theirs before single points are put to the ray tracer's test.
const ASKED: usize = 16;

/// A link that waits for its points, and the rectangle that they lie in, with their least nearness.
#[derive(Clone, Copy)]
struct Waiting {
    link: u32,
    points: u64,
    rect: Rect,
}

/// What few points meet, taken up in the order in which it was asked for: memory has time to bring it.
#[derive(Default)]
struct Ahead {
    links: [(u32, u64); RING],
    /// Links taken so far, and links put in.
    taken: usize,
    put: usize,
    /// Triangles that planes could not decide on, and a point each.
    asked: [(u32, u32); ASKED],
    asks: usize,
}

impl Ahead {
    fn is_full(&self) -> bool {
        self.put - self.taken == RING
    }

    fn put(&mut self, link: u32, points: u64) {
        self.links[self.put % RING] = (link, points);
        self.put += 1;
    }

    /// The link that waits longest, and its points.
    fn take(&mut self) -> Option<(u32, u64)> {
        (self.taken < self.put).then(|| {
            self.taken += 1;
            self.links[(self.taken - 1) % RING]
        })
    }
}

/// Where the points of a tile come from, for those that were placed without their origins.
#[derive(Clone, Copy, Default)]
pub(crate) struct Late<'a> {
    /// All origins.
    pub origins: &'a [Vec3],
    /// Which of them are the tile's.
    pub ids: &'a [u32],
}

/// Points side by side, with their origins in permuted axes.
#[repr(C, align(64))]
pub(crate) struct Tile {
    x: [f32; TILE],
    y: [f32; TILE],
    z: [f32; TILE],
    origins: [[f32; TILE]; 3],
    /// Whether these are filled in, or wait for the first question that planes cannot answer.
    has_origins: bool,
    /// Those that are in the view.
    members: u64,
    /// Those of them that are not blocked yet.
    alive: u64,
    /// The rectangle that holds them all, and the least and largest nearness.
    rect: Rect,
    far: f32,
    stack: [Waiting; STACK],
}

impl Default for Tile {
    fn default() -> Self {
        Tile {
            x: [0.0; TILE],
            y: [0.0; TILE],
            z: [0.0; TILE],
            origins: [[0.0; TILE]; 3],
            has_origins: false,
            members: 0,
            alive: 0,
            rect: Rect::EMPTY,
            far: 0.0,
            stack: [Waiting { link: 0, points: 0, rect: Rect::EMPTY }; STACK],
        }
    }
}

impl Tile {
    /// Takes the points of up to 64 rays that the view takes.
    #[inline(always)]
    pub fn fill<P: Lanes>(&mut self, lanes: P, view: &View, origins: &[Vec3]) {
        let tile = self;
        let [x, y, z] = view.axes();
        let origins = &origins[..origins.len().min(TILE)];
        for (i, o) in origins.iter().enumerate() {
            (tile.origins[0][i], tile.origins[1][i], tile.origins[2][i]) = (o[x], o[y], o[z]);
        }
        // What is not given starts nowhere, which no view takes.
        tile.origins[0][origins.len()..].fill(f32::NAN);
        tile.members = 0;
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let (mut low, mut high) = ([infinite; 3], [minus; 3]);
        for at in (0..TILE).step_by(P::WIDTH) {
            let o = &tile.origins;
            let (point, taken) = view
                .points(lanes, [lanes.load(&o[0][at..]), lanes.load(&o[1][at..]), lanes.load(&o[2][at..])]);
            tile.members |= u64::from(taken) << at;
            for axis in 0..3 {
                low[axis] = lanes.min(lanes.pick(taken, point[axis], infinite), low[axis]);
                high[axis] = lanes.max(lanes.pick(taken, point[axis], minus), high[axis]);
            }
            lanes.store(point[0], &mut tile.x[at..]);
            lanes.store(point[1], &mut tile.y[at..]);
            lanes.store(point[2], &mut tile.z[at..]);
        }
        (tile.rect, tile.far) = around(lanes, low, high);
        tile.alive = tile.members;
        tile.has_origins = true;
    }

    /// Takes up to 64 points whose places are known; their origins come late, if ever.
    #[inline(always)]
    pub fn place<P: Lanes>(&mut self, lanes: P, [x, y, z]: [&[f32]; 3], len: usize) {
        let (infinite, minus) = (lanes.splat(f32::INFINITY), lanes.splat(f32::NEG_INFINITY));
        let (mut low, mut high) = ([infinite; 3], [minus; 3]);
        for at in (0..len.min(TILE)).step_by(P::WIDTH) {
            let given = (1u32 << (len - at).min(P::WIDTH)) - 1;
            let point = [lanes.load(&x[at..]), lanes.load(&y[at..]), lanes.load(&z[at..])];
            for axis in 0..3 {
                low[axis] = lanes.min(lanes.pick(given, point[axis], infinite), low[axis]);
                high[axis] = lanes.max(lanes.pick(given, point[axis], minus), high[axis]);
            }
            lanes.store(point[0], &mut self.x[at..]);
            lanes.store(point[1], &mut self.y[at..]);
            lanes.store(point[2], &mut self.z[at..]);
        }
        (self.rect, self.far) = around(lanes, low, high);
        self.members = if len >= TILE { u64::MAX } else { (1 << len) - 1 };
        self.alive = self.members;
        self.has_origins = false;
    }

    /// The rectangle of the points with their least nearness, and the largest.
    pub fn bounds(&self) -> (Rect, f32) {
        (self.rect, self.far)
    }

    /// Whether all points are blocked.
    pub fn is_done(&self) -> bool {
        self.alive == 0
    }

    /// Holds all points, whose origins are the ones named, against a block.
    #[inline(always)]
    pub fn hold<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        view: &View,
        query: &Query<'_, A>,
        block: &Block,
        late: Late<'_>,
    ) {
        let rect = self.rect;
        self.leaf(lanes, view, query, block, self.alive, &rect, late);
    }

    /// The points that are in the view, a bit each.
    pub fn members(&self) -> u64 {
        self.members
    }

    /// The points that are blocked, a bit each.
    pub fn blocked(&self) -> u64 {
        self.members & !self.alive
    }

    /// Walks the tree until all points are blocked or nothing is left.
    #[inline(always)]
    pub fn walk<L: NodeLanes, A: AnyHit>(&mut self, lanes: L, tree: &Tree, query: &Query<'_, A>) {
        if tree.nodes.is_empty() || self.alive == 0 {
            return;
        }
        self.stack[0] = Waiting { link: 0, points: self.alive, rect: self.rect };
        let mut top = 1;
        let mut ahead = Ahead::default();
        loop {
            if top == 0 || ahead.is_full() {
                let Some((link, points)) = ahead.take() else { break };
                self.few(lanes, tree, query, (link, points & self.alive), &mut ahead, &mut top);
                continue;
            }
            top -= 1;
            let Waiting { link, points, rect } = self.stack[top & (STACK - 1)];
            let points = points & self.alive;
            if points == 0 {
                continue;
            }
            if points.count_ones() <= FEW {
                ahead.put(link, points);
            } else if link & LEAF != 0 {
                self.leaf(lanes, &tree.view, query, tree.block(link), points, &rect, Late::default());
            } else if top + 8 > STACK {
                self.singly(lanes, tree, query, link, points);
            } else {
                let node = &tree.nodes[link as usize];
                let mut hits = node.hits(lanes, &rect);
                while hits != 0 {
                    // The first child is to be taken from the stack first.
                    let slot = 31 - hits.leading_zeros();
                    hits &= !(1 << slot);
                    let slot = slot as usize & 7;
                    let child = node.rect(slot);
                    let points =
                        if child.covers(&rect) { points } else { self.inside(lanes, &child, points) };
                    if points != 0 {
                        let link = node.links[slot];
                        tree.prefetch(link);
                        self.stack[top & (STACK - 1)] = Waiting { link, points, rect: child.common(&rect) };
                        top += 1;
                    }
                }
            }
            if self.alive == 0 {
                return;
            }
        }
        self.settle(lanes, &tree.view, query, &mut ahead);
    }

    /// Holds few points against a node's children, which are put on the stack, or against a block, each by itself.
    #[inline(always)]
    fn few<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        tree: &Tree,
        query: &Query<'_, A>,
        (link, points): (u32, u64),
        ahead: &mut Ahead,
        top: &mut usize,
    ) {
        let mut rest = points;
        if link & LEAF != 0 {
            let block = tree.block(link);
            let (constant, factor) = tree.view.depth_tolerance();
            while rest != 0 {
                let i = rest.trailing_zeros() as usize & (TILE - 1);
                rest &= rest - 1;
                let point = [self.x[i], self.y[i], self.z[i]];
                let answer = block.test_one(lanes, point, constant + factor * point[2]);
                let mut possible = answer.possible;
                while possible != 0 {
                    let slot = possible.trailing_zeros() as usize & 7;
                    possible &= possible - 1;
                    let id = block.ids[slot];
                    if answer.sure >> slot & 1 == 1 && (A::IS_OPAQUE || id & ASKS == 0) {
                        self.alive &= !(1 << i);
                        break;
                    }
                    if ahead.asks == ASKED {
                        self.settle(lanes, &tree.view, query, ahead);
                    }
                    query.casters.prefetch(id);
                    ahead.asked[ahead.asks] = (id & !ASKS, i as u32);
                    ahead.asks += 1;
                }
            }
        } else if *top + 8 > STACK {
            self.singly(lanes, tree, query, link, points);
        } else {
            let node = &tree.nodes[link as usize];
            let mut each = [0u64; 8];
            let mut met = 0;
            while rest != 0 {
                let i = rest.trailing_zeros() as usize & (TILE - 1);
                rest &= rest - 1;
                let around =
                    Rect { x0: self.x[i], x1: self.x[i], y0: self.y[i], y1: self.y[i], z: self.z[i] };
                let mut hits = node.hits(lanes, &around);
                met |= hits;
                while hits != 0 {
                    each[hits.trailing_zeros() as usize & 7] |= 1 << i;
                    hits &= hits - 1;
                }
            }
            while met != 0 {
                let slot = 31 - met.leading_zeros();
                met &= !(1 << slot);
                let slot = slot as usize & 7;
                let link = node.links[slot];
                tree.prefetch(link);
                self.stack[*top & (STACK - 1)] = Waiting { link, points: each[slot], rect: Rect::EMPTY };
                *top += 1;
            }
        }
    }

    /// Puts all points that wait for it to the ray tracer's test.
    #[inline(always)]
    fn settle<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        view: &View,
        query: &Query<'_, A>,
        ahead: &mut Ahead,
    ) {
        for &(triangle, point) in &ahead.asked[..ahead.asks] {
            let i = point as usize & (TILE - 1);
            if self.alive >> i & 1 == 1 {
                let exact = Exact::new(view, &query.casters.triangles[triangle as usize]);
                let origin = [0, 1, 2].map(|axis| lanes.splat(self.origins[axis][i]));
                if query.blocked(lanes, view, triangle, &exact, origin, 1) != 0 {
                    self.alive &= !(1 << i);
                }
            }
        }
        ahead.asks = 0;
    }

    /// Those of the points that lie within a child's rectangle.
    #[inline(always)]
    fn inside<L: NodeLanes>(&self, lanes: L, rect: &Rect, points: u64) -> u64 {
        let lanes = lanes.rays();
        let (x0, x1) = (lanes.splat(rect.x0), lanes.splat(rect.x1));
        let (y0, y1) = (lanes.splat(rect.y0), lanes.splat(rect.y1));
        let far = lanes.splat(rect.z);
        let mut found = 0;
        for at in (0..TILE).step_by(L::Rays::WIDTH) {
            let (x, y, z) = (lanes.load(&self.x[at..]), lanes.load(&self.y[at..]), lanes.load(&self.z[at..]));
            let mask =
                lanes.le(x0, x) & lanes.le(x, x1) & lanes.le(y0, y) & lanes.le(y, y1) & lanes.le(z, far);
            found |= u64::from(mask) << at;
        }
        found & points
    }

    /// Points one after the other, where the stack is full.
    #[inline(always)]
    fn singly<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        tree: &Tree,
        query: &Query<'_, A>,
        link: u32,
        points: u64,
    ) {
        let mut rest = points;
        while rest != 0 {
            let i = rest.trailing_zeros() as usize & (TILE - 1);
            rest &= rest - 1;
            let point = [self.x[i], self.y[i], self.z[i]];
            if walk_one(lanes, tree, query, link, self.origin(&tree.view, i), point) {
                self.alive &= !(1 << i);
            }
        }
    }

    /// A point's origin as it was given.
    #[inline(always)]
    fn origin(&self, view: &View, i: usize) -> Vec3 {
        let o = Vec3::new(self.origins[0][i], self.origins[1][i], self.origins[2][i]);
        // Permuting by axis 0 undoes axis 1 and the other way round.
        permute(o, if view.axis == 2 { 2 } else { 1 - view.axis })
    }

    /// Holds points against a block.
    #[inline(always)]
    fn leaf<L: NodeLanes, A: AnyHit>(
        &mut self,
        lanes: L,
        view: &View,
        query: &Query<'_, A>,
        block: &Block,
        points: u64,
        rect: &Rect,
        late: Late<'_>,
    ) {
        let (constant, factor) = view.depth_tolerance();
        let spread = Spread::new(rect, rect.z, self.far, constant + factor * self.far);
        let answer = block.test_rect(lanes, &spread);
        if answer.possible == 0 {
            return;
        }
        let mut sure = answer.sure;
        while sure != 0 {
            let slot = sure.trailing_zeros() as usize & 7;
            sure &= sure - 1;
            if A::IS_OPAQUE || block.ids[slot] & ASKS == 0 {
                self.alive &= !points;
                return;
            }
        }
        let mut possible = answer.possible;
        let mut ahead = possible;
        while ahead != 0 {
            let slot = ahead.trailing_zeros() as usize & 7;
            ahead &= ahead - 1;
            query.casters.prefetch(block.ids[slot]);
        }
        while possible != 0 {
            let slot = possible.trailing_zeros() as usize & 7;
            possible &= possible - 1;
            if block.ids[slot] != NOBODY {
                self.triangle(lanes.rays(), view, query, block, slot, points, late);
            }
        }
    }

    /// Holds points against a triangle.
    #[inline(always)]
    fn triangle<P: Lanes, A: AnyHit>(
        &mut self,
        lanes: P,
        view: &View,
        query: &Query<'_, A>,
        block: &Block,
        slot: usize,
        points: u64,
        late: Late<'_>,
    ) {
        let (constant, factor) = view.depth_tolerance();
        let (constant, factor) = (lanes.splat(constant), lanes.splat(factor));
        let planes = block.spread_out(lanes, slot);
        let id = block.ids[slot];
        let asks = !A::IS_OPAQUE && id & ASKS != 0;
        let mut blocked = 0u64;
        let mut unsure = 0u64;
        let points = points & self.alive;
        for at in (0..TILE).step_by(P::WIDTH) {
            if (points >> at) as u32 & P::ALL == 0 {
                continue;
            }
            let (x, y, z) = (lanes.load(&self.x[at..]), lanes.load(&self.y[at..]), lanes.load(&self.z[at..]));
            let answer = planes.test(lanes, x, y, z, lanes.mul_add(factor, z, constant));
            blocked |= u64::from(answer.sure) << at;
            unsure |= u64::from(answer.possible) << at;
        }
        blocked = if asks { 0 } else { blocked & points };
        unsure &= points & !blocked;
        if unsure != 0 {
            if !self.has_origins {
                self.find_origins(view, late);
            }
            blocked |= self.ask(lanes, view, query, id & !ASKS, unsure);
        }
        self.alive &= !blocked;
    }

    #[inline(always)]
    fn find_origins(&mut self, view: &View, Late { origins, ids }: Late<'_>) {
        let [x, y, z] = view.axes();
        for (i, id) in ids.iter().take(TILE).enumerate() {
            let o = origins[*id as usize];
            (self.origins[0][i], self.origins[1][i], self.origins[2][i]) = (o[x], o[y], o[z]);
        }
        self.has_origins = true;
    }

    /// Of points that planes cannot decide on, those that the ray tracer finds blocked.
    #[inline(always)]
    fn ask<P: Lanes, A: AnyHit>(
        &self,
        lanes: P,
        view: &View,
        query: &Query<'_, A>,
        triangle: u32,
        unsure: u64,
    ) -> u64 {
        let exact = Exact::new(view, &query.casters.triangles[triangle as usize]);
        let mut blocked = 0u64;
        for at in (0..TILE).step_by(P::WIDTH) {
            let mask = (unsure >> at) as u32 & P::ALL;
            if mask != 0 {
                let o = &self.origins;
                let origin = [lanes.load(&o[0][at..]), lanes.load(&o[1][at..]), lanes.load(&o[2][at..])];
                blocked |= u64::from(query.blocked(lanes, view, triangle, &exact, origin, mask)) << at;
            }
        }
        blocked
    }
}

/// The rectangle with the least nearness, and the largest, from those of each lane.
#[inline(always)]
pub(crate) fn around<P: Lanes>(lanes: P, low: [P::F; 3], high: [P::F; 3]) -> (Rect, f32) {
    let rect = Rect {
        x0: lanes.least(low[0]),
        x1: lanes.most(high[0]),
        y0: lanes.least(low[1]),
        y1: lanes.most(high[1]),
        z: lanes.least(low[2]),
    };
    (rect, lanes.most(high[2]))
}
