//! The nodes of a binary search tree in one array, for [`super::treap`] and [`super::sample_tree`].
//!
//! Place 0 is no node but the head: its right child is the root, and 0 as a child means none. Places of
//! nodes that were taken out are used again.

use sweep_cdt::front::FrontNode;

/// The head, and no child.
pub(super) const NONE: u32 = 0;
/// The two sides of a node.
pub(super) const LEFT: usize = 0;
pub(super) const RIGHT: usize = 1;

/// A node of the front with its x, in the order of the tree.
pub(super) type Key = (f64, FrontNode);

#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub(super) key: Key,
    pub(super) children: [u32; 2],
}

#[derive(Clone, Debug)]
pub(super) struct Arena {
    branches: Vec<Branch>,
    free: Vec<u32>,
}

impl Default for Arena {
    fn default() -> Arena {
        let head = Branch {
            key: (f64::NEG_INFINITY, FrontNode::from_rank(0)),
            children: [NONE; 2],
        };
        Arena {
            branches: vec![head],
            free: Vec::new(),
        }
    }
}

impl Arena {
    /// All places ever used, the head among them.
    pub(super) fn len(&self) -> usize {
        self.branches.len()
    }

    /// A place for a node without children.
    pub(super) fn add(&mut self, key: Key) -> u32 {
        let branch = Branch {
            key,
            children: [NONE; 2],
        };
        if let Some(place) = self.free.pop() {
            self.branches[place as usize] = branch;
            return place;
        }
        self.branches.push(branch);
        u32::try_from(self.branches.len() - 1).expect("no more nodes than vertices")
    }

    /// Forgets a node, which no other has as its child.
    pub(super) fn free(&mut self, place: u32) {
        self.free.push(place);
    }

    pub(super) fn key(&self, place: u32) -> Key {
        self.branches[place as usize].key
    }

    pub(super) fn child(&self, place: u32, side: usize) -> u32 {
        self.branches[place as usize].children[side]
    }

    pub(super) fn set_child(&mut self, place: u32, side: usize, child: u32) {
        self.branches[place as usize].children[side] = child;
    }

    pub(super) fn root(&self) -> u32 {
        self.child(NONE, RIGHT)
    }

    pub(super) fn set_root(&mut self, root: u32) {
        self.set_child(NONE, RIGHT, root);
    }
}
