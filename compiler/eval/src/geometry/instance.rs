//! What a module's function works on.

use std::sync::Arc;

use chiaro_solid::{Dimension, Solid};
use chiaro_syntax::{Diagnostic, Span};

use super::arguments::{self, Bound};
use super::booleans::union_of;
use super::facets::Facets;
use super::make::is_empty;
use super::{Aside, Built, Call, OnlyChild, Stop};
use crate::value::Value;

/// One built-in module.
pub(super) struct Module {
    /// Its name in scenes.
    pub(super) name: &'static str,
    /// Its parameters that arguments without a name go to, in order.
    pub(super) positional: &'static [&'static str],
    /// Its parameters that have to be named.
    pub(super) named: &'static [&'static str],
    /// What it does.
    pub(super) build: fn(&mut Instance) -> Built,
}

/// An instance of a built-in module, its arguments bound to parameters.
pub(super) struct Instance<'a> {
    /// The module's name.
    pub(super) name: &'a str,
    /// Name and arguments in the text.
    pub(super) head: Span,
    /// `$fn`, the number of sides of curves.
    pub(super) number_of_sides: Value,
    /// What `$fn` does.
    pub(super) facets: Facets,
    /// Whether all that counts of the solid is its convex hull.
    pub(super) only_hull: bool,
    /// What the children came to.
    pub(super) children: Vec<Arc<Solid>>,
    /// The only child that is written, if there is one only.
    pub(super) only_child: Option<OnlyChild>,
    /// What the children have put aside.
    pub(super) aside: &'a mut Aside,
    pub(super) arguments: Vec<Bound>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'a> Instance<'a> {
    /// Binds the call's arguments to these parameters. All live numbers among them are finite.
    pub(super) fn bind(
        call: Call<'a>,
        positional: &[&'static str],
        named: &[&'static str],
        facets: Facets,
        diagnostics: &'a mut Vec<Diagnostic>,
    ) -> Result<Self, Stop> {
        let arguments = arguments::bind(call.name, call.arguments, positional, named, diagnostics);
        arguments::check_live(&arguments)?;
        Ok(Self {
            name: call.name,
            head: call.head,
            number_of_sides: call.sides,
            facets,
            only_hull: call.only_hull,
            children: call.children,
            only_child: call.only_child,
            aside: call.aside,
            arguments,
            diagnostics,
        })
    }

    /// Reports that the solid may not be what was meant.
    pub(super) fn warn(&mut self, span: Span, message: impl Into<String>) {
        self.report(Diagnostic::warning(span, message));
    }

    /// Reports a diagnostic that is not an error.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// The children as one.
    pub(super) fn union(&mut self) -> Arc<Solid> {
        union_of(std::mem::take(&mut self.children), self.head, self.diagnostics)
    }

    /// The children of one dimension as one; the others are left out with a warning.
    pub(super) fn union_in(&mut self, dimension: Dimension) -> Arc<Solid> {
        self.keep_only(dimension);
        self.union()
    }

    /// Says that what stands behind a shape is left out: most often, a semicolon is missing.
    pub(super) fn without_children(&mut self) {
        if let Some(child) = self.children.iter().find(|child| !is_empty(child)) {
            self.leave_out(child.span);
        }
        self.without_aside();
    }

    /// Says that a child is left out.
    pub(super) fn leave_out(&mut self, child: Span) {
        let message = format!("`{}` takes no children: this is left out", self.name);
        let warning = Diagnostic::warning(child, message).with_related(self.head, "left out here");
        self.report(warning.with_hint(format!("to have both, end `{}(…)` with `;`", self.name)));
    }

    /// The children that are not empty, of the first one's dimension.
    pub(super) fn operands(&mut self) -> Vec<Arc<Solid>> {
        self.children.retain(|child| !is_empty(child));
        if let Some(dimension) = self.children.first().and_then(|first| first.dimension()) {
            self.keep_only(dimension);
        }
        std::mem::take(&mut self.children)
    }

    /// Leaves out, with a warning, what is not of this dimension. Empty children stay.
    pub(super) fn keep_only(&mut self, dimension: Dimension) {
        let children = std::mem::take(&mut self.children);
        let (kept, others): (Vec<_>, Vec<_>) =
            children.into_iter().partition(|child| child.dimension().is_none_or(|is| is == dimension));
        let (are, takes) = match dimension {
            Dimension::Plane => ("a solid", "plane shapes"),
            Dimension::Space => ("a plane shape", "solids"),
        };
        for child in others {
            let message = format!("`{}` takes {takes}: this is {are} and is left out", self.name);
            self.report(Diagnostic::warning(child.span, message).with_related(self.head, "left out here"));
        }
        self.children = kept;
    }
}

/// An error about `span`.
pub(super) fn error(span: Span, message: impl Into<String>) -> Stop {
    Stop::Error(Box::new(Diagnostic::error(span, message)))
}
