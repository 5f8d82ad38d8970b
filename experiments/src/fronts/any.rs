//! A structure of any type, chosen when the program runs.
//!
//! With it one compiled sweep serves all structures where time does not matter: to count, and in tests.

use std::fmt;

use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch};

use super::structure::{Structure, Work};

/// A structure whose type is forgotten.
trait Object {
    fn front(&mut self) -> &mut dyn FrontSearch;
    fn work(&self) -> Option<Work>;
    fn copy(&self) -> Box<dyn Object>;
}

impl<S: Structure> Object for S {
    fn front(&mut self) -> &mut dyn FrontSearch {
        self
    }

    fn work(&self) -> Option<Work> {
        Structure::work(self)
    }

    fn copy(&self) -> Box<dyn Object> {
        Box::new(self.clone())
    }
}

/// Any [`Structure`].
pub struct AnyFront(Box<dyn Object>);

impl AnyFront {
    /// This structure, its type forgotten.
    pub fn new(structure: impl Structure) -> AnyFront {
        AnyFront(Box::new(structure))
    }
}

impl Clone for AnyFront {
    fn clone(&self) -> AnyFront {
        AnyFront(self.0.copy())
    }
}

impl fmt::Debug for AnyFront {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("AnyFront").field(&self.0.work()).finish()
    }
}

impl FrontSearch for AnyFront {
    fn begin(&mut self, domain: Domain<'_>) {
        self.0.front().begin(domain);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.0.front().locate(x, front)
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.0.front().strayed(steps)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.0.front().inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.0.front().removed(node, x);
    }
}

impl Structure for AnyFront {
    fn work(&self) -> Option<Work> {
        self.0.work()
    }
}
