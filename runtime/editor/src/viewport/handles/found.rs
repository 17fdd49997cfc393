//! Which handles the selected solid has.

use chiaro_assist::{CallArgument, Literal, literals_of_call};
use chiaro_compiler::{Matrix, Origin};

use super::{Handle, Number};
use crate::app::Editor;
use crate::document::Document;

/// How many of the expressions around a solid offer handles: the nearest.
const MOST_CALLS: usize = 3;
/// How far before a place the handles that move it are drawn, in points.
const MOVE_AHEAD: f32 = 28.0;

/// The handles of the selection's expression and of the nearest moves around it.
pub(super) fn handles(editor: &Editor) -> Vec<Handle> {
    let (Some(selection), Some(shown)) = (&editor.viewport.selection, &editor.session.shown) else { return Vec::new() };
    let parameters = editor.session.parameters();
    let mut handles = Vec::new();
    for origin in selection.chain.iter().skip(selection.at).take(MOST_CALLS) {
        let name = &shown.sources.get(origin.span.file).name;
        let Some(document) = editor.session.documents().iter().find(|open| open.name() == *name) else { continue };
        let Some(arguments) = literals_of_call(&document.text, origin.span.range()) else { continue };
        // Where something above bends the solid, its numbers have no straight lines to move along.
        let Ok(matrix) = selection.provenance.placement(origin.solid, &parameters) else { continue };
        let call = Call { document, arguments, matrix };
        let own = call.handles(origin);
        let is_shape = !own.is_empty();
        handles.extend(own);
        if is_shape && origin.what == "translate" {
            break;
        }
    }
    handles
}

/// An instance of a module, with what its numbers mean in the world.
struct Call<'a> {
    document: &'a Document,
    arguments: Vec<CallArgument>,
    matrix: Matrix,
}

impl Call<'_> {
    fn handles(&self, origin: &Origin) -> Vec<Handle> {
        match origin.what.as_str() {
            "translate" => self.moves(),
            "sphere" | "circle" => self.radius([0.0; 3]),
            "cylinder" => {
                let height = self.value("h").unwrap_or(1.0);
                let (low, high) = if self.is_centred() { (-0.5 * height, 0.5 * height) } else { (0.0, height) };
                let mut handles = self.radius([0.0, 0.0, 0.5 * (low + high)]);
                let share = if self.is_centred() { 0.5 } else { 1.0 };
                handles.extend(self.handle("h", &self.literal("h"), [0.0, 0.0, high], [0.0, 0.0, share]));
                handles
            }
            "cube" | "square" => self.size(if origin.what == "cube" { 3 } else { 2 }),
            "linear_extrude" => {
                let height = self.value("height").unwrap_or(1.0);
                let share = if self.is_centred() { 0.5 } else { 1.0 };
                let top = [0.0, 0.0, share * height];
                self.handle("height", &self.literal("height"), top, [0.0, 0.0, share]).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// `translate([x, y, z])`: one along each axis.
    fn moves(&self) -> Vec<Handle> {
        let Some(Literal::List(numbers)) = self.literal("v") else {
            let along = [1.0, 0.0, 0.0];
            return self.handle("v", &self.literal("v"), [0.0; 3], along).into_iter().collect();
        };
        let value = |axis: usize| numbers.get(axis).and_then(number).unwrap_or(0.0);
        let at = [value(0), value(1), value(2)];
        let axis = |axis: usize| {
            let mut along = [0.0; 3];
            along[axis] = 1.0;
            let handle = self.handle(["x", "y", "z"][axis], &numbers.get(axis).cloned(), at, along)?;
            Some(Handle { ahead: MOVE_AHEAD, ..handle })
        };
        (0..numbers.len().min(3)).filter_map(axis).collect()
    }

    /// A radius or a diameter, along x from a centre.
    fn radius(&self, centre: [f64; 3]) -> Vec<Handle> {
        let names = ["r", "r1", "d", "d1"];
        let named = names.into_iter().find_map(|name| Some((name, self.literal(name)?)));
        let Some((name, literal)) = named else { return Vec::new() };
        let share = if name.starts_with('d') { 0.5 } else { 1.0 };
        let radius = share * number(&literal).unwrap_or(1.0);
        let at = [centre[0] + radius, centre[1], centre[2]];
        self.handle(name, &Some(literal), at, [share, 0.0, 0.0]).into_iter().collect()
    }

    /// The size of a box: one at the middle of each face ahead.
    fn size(&self, axes: usize) -> Vec<Handle> {
        let literal = self.literal("size");
        let share = if self.is_centred() { 0.5 } else { 1.0 };
        let middle = |edge: f64| if self.is_centred() { 0.0 } else { 0.5 * edge };
        match &literal {
            Some(Literal::List(numbers)) => {
                let edges: Vec<f64> = (0..3).map(|axis| numbers.get(axis).and_then(number).unwrap_or(0.0)).collect();
                let face = |axis: usize| {
                    let mut at = [middle(edges[0]), middle(edges[1]), middle(edges[2])];
                    let mut along = [0.0; 3];
                    (at[axis], along[axis]) = (share * edges[axis], share);
                    self.handle(["x", "y", "z"][axis], &numbers.get(axis).cloned(), at, along)
                };
                (0..axes.min(numbers.len())).filter_map(face).collect()
            }
            _ => {
                let edge = literal.as_ref().and_then(number).unwrap_or(1.0);
                let height = if axes == 3 { middle(edge) } else { 0.0 };
                let at = [share * edge, middle(edge), height];
                self.handle("size", &literal, at, [share, 0.0, 0.0]).into_iter().collect()
            }
        }
    }

    /// A handle at a point of the call's own coordinates.
    fn handle(&self, label: &str, literal: &Option<Literal>, at: [f64; 3], along: [f64; 3]) -> Option<Handle> {
        let number = match literal.as_ref()? {
            Literal::Number(number) => {
                Ok(Number { document: self.document.id, range: number.range.clone(), value: number.value })
            }
            Literal::Computed(reason) => Err(reason.clone()),
            Literal::List(_) | Literal::Other => return None,
        };
        let m = &self.matrix;
        let turned = |v: [f64; 3]| [0, 1, 2].map(|row| m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2]);
        let moved = turned(at);
        let at = [0, 1, 2].map(|row| moved[row] + m[row][3]);
        Some(Handle { label: label.to_owned(), at, along: turned(along), ahead: 0.0, number })
    }

    fn literal(&self, name: &str) -> Option<Literal> {
        let is_it = |argument: &&CallArgument| argument.parameter.as_deref() == Some(name);
        self.arguments.iter().find(is_it).map(|argument| argument.value.clone())
    }

    fn value(&self, name: &str) -> Option<f64> {
        number(&self.literal(name)?)
    }

    /// Whether the call says `center = true`.
    fn is_centred(&self) -> bool {
        let centre = self.arguments.iter().find(|argument| argument.parameter.as_deref() == Some("center"));
        centre.is_some_and(|argument| {
            self.document.text.get(argument.range.clone()).is_some_and(|text| text.ends_with("true"))
        })
    }
}

fn number(literal: &Literal) -> Option<f64> {
    match literal {
        Literal::Number(number) => Some(number.value),
        _ => None,
    }
}
