//! Which handles the selected solid has.

use chiaro_assist::{CallArgument, Literal, literals_of_call};
use chiaro_compiler::solid::SolidKind;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::{Matrix, Origin, SolidId};

use super::{Handle, Number};
use crate::app::Editor;
use crate::document::Document;
use crate::viewport::Selection;

/// How many of the expressions around a solid offer handles: the nearest.
const MOST_CALLS: usize = 3;
const AXES: [&str; 3] = ["x", "y", "z"];
/// How far before a place the handles that move it are drawn, in points.
const MOVE_AHEAD: f32 = 28.0;

/// The handles of the selection's expression and of the nearest moves around it; or why there are none.
pub(super) fn handles(editor: &Editor) -> Result<Vec<Handle>, String> {
    let (Some(selection), Some(shown)) = (&editor.viewport.selection, &editor.session.shown) else {
        return Ok(Vec::new());
    };
    let parameters = editor.session.parameters();
    let (mut handles, mut obstacle) = (Vec::new(), None);
    for origin in selection.chain.iter().skip(selection.at).take(MOST_CALLS) {
        let name = &shown.sources.get(origin.span.file).name;
        let Some(document) = editor.session.documents().iter().find(|open| open.name() == *name) else {
            obstacle.get_or_insert_with(|| format!("{name} is not open"));
            continue;
        };
        // (What is being typed need not be a call yet.)
        let Some(arguments) = literals_of_call(&document.text, origin.span.range()) else { continue };
        let matrix = match selection.provenance.placement(origin.solid, &parameters) {
            Ok(matrix) => matrix,
            Err(bent) => {
                obstacle.get_or_insert_with(|| format!("`{}` bends the lines along which they would move", bent.what));
                continue;
            }
        };
        let call = Call { document, arguments, matrix, selection, solid: origin.solid, parameters: &parameters };
        let own = call.handles(origin);
        let is_shape = !own.is_empty();
        handles.extend(own);
        if is_shape && origin.what == "translate" {
            break;
        }
    }
    match obstacle {
        Some(obstacle) if handles.is_empty() => Err(obstacle),
        _ => Ok(handles),
    }
}

/// An instance of a module, with what its numbers mean in the world.
struct Call<'a> {
    document: &'a Document,
    arguments: Vec<CallArgument>,
    matrix: Matrix,
    selection: &'a Selection,
    solid: SolidId,
    parameters: &'a [f64],
}

impl Call<'_> {
    fn handles(&self, origin: &Origin) -> Vec<Handle> {
        match origin.what.as_str() {
            "translate" => self.moves(),
            "sphere" | "circle" => self.radius(0.0).into_iter().collect(),
            "cylinder" => {
                let middle = if self.is_centred() { 0.0 } else { 0.5 * self.height("h") };
                self.radius(middle).into_iter().chain(self.top("h")).collect()
            }
            "cube" => self.size(3),
            "square" => self.size(2),
            "linear_extrude" => self.top("height").into_iter().collect(),
            _ => Vec::new(),
        }
    }

    /// `translate([x, y, z])`: one along each axis; of a computed vector, one that says so.
    fn moves(&self) -> Vec<Handle> {
        let made = self.shift();
        match self.literal("v") {
            Some(Literal::List(numbers)) => {
                let at = [0, 1, 2].map(|axis| numbers.get(axis).and_then(number).unwrap_or(made[axis]));
                let along = |axis: usize| {
                    let handle = self.handle(AXES[axis], &numbers[axis], at, unit(axis, 1.0))?;
                    Some(Handle { ahead: MOVE_AHEAD, ..handle })
                };
                (0..numbers.len().min(3)).filter_map(along).collect()
            }
            Some(literal) => self.handle("v", &literal, made, unit(0, 1.0)).into_iter().collect(),
            None => Vec::new(),
        }
    }

    /// A radius or a diameter, along x from the axis.
    fn radius(&self, height: f64) -> Option<Handle> {
        let names = ["r", "r1", "d", "d1"];
        let (name, literal) = names.into_iter().find_map(|name| Some((name, self.literal(name)?)))?;
        let share = if name.starts_with('d') { 0.5 } else { 1.0 };
        let radius = number(&literal).map_or_else(|| self.bounds().max[0], |number| share * number);
        self.handle(name, &literal, [radius, 0.0, height], unit(0, share))
    }

    /// The height of what stands on the plane z = 0, or is centred on it: at its top.
    fn top(&self, name: &str) -> Option<Handle> {
        let share = self.share();
        self.handle(name, &self.literal(name)?, [0.0, 0.0, share * self.height(name)], unit(2, share))
    }

    fn height(&self, name: &str) -> f64 {
        self.literal(name).as_ref().and_then(number).unwrap_or_else(|| self.bounds().size()[2])
    }

    /// The size of a box: one at the middle of each face ahead.
    fn size(&self, axes: usize) -> Vec<Handle> {
        let Some(literal) = self.literal("size") else { return Vec::new() };
        let (share, made) = (self.share(), self.bounds().size());
        let edges: [f64; 3] = match &literal {
            Literal::List(numbers) => [0, 1, 2].map(|axis| numbers.get(axis).and_then(number).unwrap_or(made[axis])),
            literal => number(literal).map_or(made, |edge| [edge; 3]),
        };
        let middle = [0, 1, 2].map(|axis| if self.is_centred() || axis >= axes { 0.0 } else { 0.5 * edges[axis] });
        let face = |name: &str, axis: usize, literal: &Literal| {
            let mut at = middle;
            at[axis] = share * edges[axis];
            self.handle(name, literal, at, unit(axis, share))
        };
        match &literal {
            Literal::List(numbers) => {
                let faces = numbers.iter().take(axes).enumerate();
                faces.filter_map(|(axis, literal)| face(AXES[axis], axis, literal)).collect()
            }
            literal => face("size", 0, literal).into_iter().collect(),
        }
    }

    /// A handle at a point of the call's own coordinates.
    fn handle(&self, label: &str, literal: &Literal, at: [f64; 3], along: [f64; 3]) -> Option<Handle> {
        let number = match literal {
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

    /// The box that it came to, which tells what was computed.
    fn bounds(&self) -> Bounds {
        self.selection.provenance.local_bounds(self.solid, self.parameters)
    }

    /// How far it moves what is in it.
    fn shift(&self) -> [f64; 3] {
        match &self.selection.provenance.solid(self.solid).kind {
            SolidKind::Transform(map, _) => map.value(self.parameters).map(|row| row[3]),
            _ => [0.0; 3],
        }
    }

    /// How much of a length is ahead of the origin.
    fn share(&self) -> f64 {
        if self.is_centred() { 0.5 } else { 1.0 }
    }

    /// Whether the call says `center = true`.
    fn is_centred(&self) -> bool {
        let centre = self.arguments.iter().find(|argument| argument.parameter.as_deref() == Some("center"));
        centre.is_some_and(|argument| {
            self.document.text.get(argument.range.clone()).is_some_and(|text| text.ends_with("true"))
        })
    }
}

/// A vector along an axis.
fn unit(axis: usize, length: f64) -> [f64; 3] {
    let mut vector = [0.0; 3];
    vector[axis] = length;
    vector
}

fn number(literal: &Literal) -> Option<f64> {
    match literal {
        Literal::Number(number) => Some(number.value),
        _ => None,
    }
}
