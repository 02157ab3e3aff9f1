//! A tree of rectangles over the triangles of one view: eight children to a node, a block of eight triangles to a leaf.

use crate::block::{BLOCK, Block};
use crate::casters::Casters;
use crate::rect::{Rect, rects};
use crate::split::{Item, split};
use crate::view::View;
use alloc::vec::Vec;
use lt_bvh::Triangle;
use lt_bvh::lanes::{Chosen, Lanes, NodeLanes, Work, prefetch};

/// Children to a node.
pub(crate) const WIDTH: usize = 8;
/// Bit of a link that leads to a block.
pub(crate) const LEAF: u32 = 0x8000_0000;
/// Link of an empty slot.
const NOWHERE: u32 = u32::MAX;
/// Ranges of at least this many items are built as tasks of their own; a multiple of [`BLOCK`].
const TASK: usize = 4096;

/// Eight rectangles side by side.
#[repr(C, align(64))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub x0: [f32; WIDTH],
    pub x1: [f32; WIDTH],
    pub y0: [f32; WIDTH],
    pub y1: [f32; WIDTH],
    pub z: [f32; WIDTH],
    pub links: [u32; WIDTH],
}

impl Node {
    const EMPTY: Self = Self {
        x0: [f32::INFINITY; WIDTH],
        x1: [f32::NEG_INFINITY; WIDTH],
        y0: [f32::INFINITY; WIDTH],
        y1: [f32::NEG_INFINITY; WIDTH],
        z: [f32::NEG_INFINITY; WIDTH],
        links: [NOWHERE; WIDTH],
    };

    fn set(&mut self, slot: usize, rect: &Rect, link: u32) {
        self.x0[slot] = rect.x0;
        self.x1[slot] = rect.x1;
        self.y0[slot] = rect.y0;
        self.y1[slot] = rect.y1;
        self.z[slot] = rect.z;
        self.links[slot] = link;
    }

    /// The links that lead somewhere, the first slots'.
    pub fn children(&self) -> impl Iterator<Item = u32> {
        self.links.into_iter().filter(|link| *link != NOWHERE)
    }

    /// A child's rectangle.
    #[inline(always)]
    pub fn rect(&self, slot: usize) -> Rect {
        Rect { x0: self.x0[slot], x1: self.x1[slot], y0: self.y0[slot], y1: self.y1[slot], z: self.z[slot] }
    }

    /// The children that may block something within `around`, whose `z` is the least nearness.
    #[inline(always)]
    pub fn hits<L: Lanes>(&self, lanes: L, around: &Rect) -> u32 {
        lanes.le(lanes.load(&self.x0), lanes.splat(around.x1))
            & lanes.le(lanes.splat(around.x0), lanes.load(&self.x1))
            & lanes.le(lanes.load(&self.y0), lanes.splat(around.y1))
            & lanes.le(lanes.splat(around.y0), lanes.load(&self.y1))
            & lanes.le(lanes.splat(around.z), lanes.load(&self.z))
    }
}

/// The tree of one view.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    pub view: View,
    /// The root first; empty without triangles.
    pub nodes: Vec<Node>,
    pub blocks: Vec<Block>,
}

/// A tree or part of one, its links counted from its own start.
#[derive(Default)]
struct Part {
    nodes: Vec<Node>,
    blocks: Vec<Block>,
}

impl Part {
    /// Takes over another part's nodes and blocks; where its root now is.
    fn append(&mut self, other: Part) -> u32 {
        let (node, block) = (self.nodes.len() as u32, self.blocks.len() as u32);
        self.nodes.extend(other.nodes.into_iter().map(|mut n| {
            for link in n.links.iter_mut().filter(|l| **l != NOWHERE) {
                *link += if *link & LEAF != 0 { block } else { node };
            }
            n
        }));
        self.blocks.extend(other.blocks);
        node
    }
}

struct Builder<'a> {
    chosen: Chosen,
    view: &'a View,
    casters: Casters<'a>,
}

impl Tree {
    /// Builds over all triangles that the view can see. The same tree for any number of threads.
    pub fn build(view: View, casters: Casters<'_>) -> Self {
        let mut items = items(&view, casters);
        let chosen = Chosen::best();
        let builder = Builder { chosen, view: &view, casters };
        let part = if items.is_empty() { Part::default() } else { builder.subtree(&mut items) };
        Tree { view, nodes: part.nodes, blocks: part.blocks }
    }

    /// Asks for what a link leads to, that it may have come by the time it is needed.
    #[inline(always)]
    pub fn prefetch(&self, link: u32) {
        if link & LEAF == 0 {
            prefetch(&self.nodes[link as usize]);
        } else {
            prefetch(self.block(link));
        }
    }

    /// What a leaf's link leads to.
    #[inline(always)]
    pub fn block(&self, link: u32) -> &Block {
        &self.blocks[(link & !LEAF) as usize]
    }
}

/// The triangles that a view can see, with their rectangles, in the order of the triangles. The same on all instructions.
pub(crate) fn items(view: &View, casters: Casters<'_>) -> Vec<Item> {
    let mut items = Vec::new();
    fill_items(view, casters, &mut items);
    items
}

/// [`items`] in a list that has memory already.
pub(crate) fn fill_items(view: &View, casters: Casters<'_>, items: &mut Vec<Item>) {
    let chosen = Chosen::best();
    items.resize(casters.triangles.len(), Item { rect: Rect::EMPTY, triangle: 0 });
    let one = |(at, items): (usize, &mut [Item])| {
        let first = at * TASK;
        let triangles = &casters.triangles[first..first + items.len()];
        chosen.run(Rectangles { view, triangles, first: first as u32, items });
    };
    #[cfg(feature = "std")]
    {
        use rayon::prelude::*;
        items.par_chunks_mut(TASK).enumerate().for_each(one);
    }
    #[cfg(not(feature = "std"))]
    items.chunks_mut(TASK).enumerate().for_each(one);
    if !view.sees_all() {
        items.retain(|item| item.rect.x0 <= item.rect.x1);
    }
}

/// Fills in the rectangles of some triangles.
struct Rectangles<'a> {
    view: &'a View,
    triangles: &'a [Triangle],
    /// Place of the first of them.
    first: u32,
    items: &'a mut [Item],
}

impl Work for Rectangles<'_> {
    type Output = ();
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) {
        let mut triangle = self.first;
        for (triangles, items) in self.triangles.chunks(BLOCK).zip(self.items.chunks_mut(BLOCK)) {
            for (item, rect) in items.iter_mut().zip(rects(lanes, self.view, triangles)) {
                *item = Item { rect, triangle };
                triangle += 1;
            }
        }
    }
}

impl Builder<'_> {
    /// The tree over these items, at least one.
    fn subtree(&self, items: &mut [Item]) -> Part {
        // Ranges of `items`, split where it pays most until there are eight.
        let mut ranges: Vec<&mut [Item]> = Vec::with_capacity(WIDTH);
        ranges.push(items);
        while ranges.len() < WIDTH {
            let heaviest = ranges
                .iter()
                .enumerate()
                .filter(|(_, items)| items.len() > BLOCK)
                .map(|(i, items)| (i, bounds(items).area() * items.len() as f32, items.len()))
                .max_by(|a, b| a.1.total_cmp(&b.1).then(a.2.cmp(&b.2)).then(b.0.cmp(&a.0)));
            let Some((at, ..)) = heaviest else { break };
            let items = ranges.swap_remove(at);
            let middle = split(items);
            let (left, right) = items.split_at_mut(middle);
            ranges.push(left);
            ranges.push(right);
        }
        // The large ones first: they are likeliest to block, and what is blocked is passed no further.
        let mut children: Vec<(Rect, &mut [Item])> =
            ranges.into_iter().map(|items| (bounds(items), items)).collect();
        children.sort_by(|a, b| b.0.area().total_cmp(&a.0.area()));
        let mut part = Part { nodes: alloc::vec![Node::EMPTY], blocks: Vec::new() };
        let parts = self.parts(&mut children);
        for (slot, ((rect, items), child)) in children.iter().zip(parts).enumerate() {
            let link = match child {
                Some(child) => part.append(child),
                None => {
                    part.blocks.push(self.block(items));
                    LEAF | (part.blocks.len() - 1) as u32
                }
            };
            part.nodes[0].set(slot, rect, link);
        }
        part
    }

    /// The trees of the children that are not leaves.
    fn parts(&self, children: &mut [(Rect, &mut [Item])]) -> Vec<Option<Part>> {
        let one = |(_, items): &mut (Rect, &mut [Item])| (items.len() > BLOCK).then(|| self.subtree(items));
        #[cfg(feature = "std")]
        if children.iter().map(|c| c.1.len()).sum::<usize>() >= TASK {
            use rayon::prelude::*;
            return children.par_iter_mut().map(one).collect();
        }
        children.iter_mut().map(one).collect()
    }

    fn block(&self, items: &[Item]) -> Block {
        let mut ids = [0; BLOCK];
        for (id, item) in ids.iter_mut().zip(items) {
            *id = item.triangle;
        }
        let ids = &ids[..items.len().min(BLOCK)];
        self.chosen.run(Leaf { view: self.view, casters: self.casters, ids })
    }
}

/// Makes a block.
struct Leaf<'a> {
    view: &'a View,
    casters: Casters<'a>,
    ids: &'a [u32],
}

impl Work for Leaf<'_> {
    type Output = Block;
    #[inline(always)]
    fn run<L: NodeLanes>(self, lanes: L) -> Block {
        Block::of(lanes, self.view, self.casters, self.ids)
    }
}

fn bounds(items: &[Item]) -> Rect {
    items.iter().fold(Rect::EMPTY, |all, item| all.union(&item.rect))
}
