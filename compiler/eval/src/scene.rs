//! The scene as a whole: its top level, the files it uses, its view.

use std::rc::Rc;
use std::sync::Arc;

use chiaro_solid::{Camera, Emitter, LiveParameter, PlacedLight, Scalar, Scene, Solid, SolidKind};
use chiaro_syntax::tree::{Expression, Statement};
use chiaro_syntax::{Diagnostic, FileId, Severity, SourceFile, Sources, Span, parse};

use crate::evaluator::{Evaluator, Result, Unit};
use crate::geometry::{Demotion, PlacedCamera};
use crate::live::{Live, Structural};
use crate::load::{FileIndex, load};
use crate::options::{Options, World};
use crate::plan::Plan;
use crate::scope::{Scope, Slot, Specials};
use crate::value::Value;
use crate::{misspelt, suggest};

/// What evaluating a scene came to.
#[derive(Debug)]
pub struct Evaluation {
    /// The scene, if there is no error.
    pub scene: Option<Scene>,
    /// What there is to tell: the output of `echo` as notes in the order of execution, then everything else in the
    /// order of the text, and in the end which parameters are not live.
    pub diagnostics: Vec<Diagnostic>,
}

/// How often a scene is evaluated to find out which parameters decide its structure, before all are taken to do so.
const MOST_ROUNDS: usize = 10;

/// A variable set from outside.
struct Definition {
    name: String,
    value: Expression,
    span: Span,
}

/// Evaluates the file `main`, and whatever it includes and uses, to a scene.
///
/// If a file can't be read, or a definition can't be parsed, that is all there is to tell: nothing
/// is evaluated then. Of a file with syntax errors only names are told besides that are misspelt
/// however it is mended.
///
/// The calling thread needs a stack of [`STACK_BYTES`](crate::STACK_BYTES). The scene's parameters are all those live
/// numbers that the text declares and that did not become structural, used or not; `$t` is among them only if it is
/// used.
pub fn evaluate(world: &dyn World, sources: &mut Sources, main: FileId, options: &Options) -> Evaluation {
    let mut diagnostics = Vec::new();
    let library = load(world, sources, main, &options.limits, &mut diagnostics);
    let mut faults = Vec::new();
    let definitions = definitions(sources, options, &mut faults);
    let is_broken = has_errors(&diagnostics);
    if is_broken && !library.is_complete || has_errors(&faults) {
        // What is missing would be missed everywhere.
        diagnostics.extend(faults);
        return Evaluation { scene: None, diagnostics };
    }
    let mut structural = Structural::default();
    // Each round makes at least one parameter structural, and the last one all that are left.
    let mut round = 0;
    loop {
        round += 1;
        let mut evaluator = Evaluator::new(&library, sources, options, Live::new(&structural, options));
        let result = evaluator.scene(&definitions);
        let parameters = std::mem::take(&mut evaluator.live.parameters);
        let reports = std::mem::take(&mut evaluator.diagnostics);
        let echoes = std::mem::take(&mut evaluator.echoes);
        let demotions = std::mem::take(&mut evaluator.demotions);
        drop(evaluator);
        if structural.demote(&demotions, &parameters, round >= MOST_ROUNDS) {
            continue;
        }
        if is_broken {
            let certain = misspelt::certain(reports, &library, sources, &diagnostics);
            diagnostics.extend(certain);
            diagnostics.sort_by_key(place);
            return Evaluation { scene: None, diagnostics };
        }
        diagnostics.extend(demotions.iter().map(unknown_number));
        diagnostics.extend(reports);
        diagnostics.sort_by_key(place);
        let failed = has_errors(&diagnostics);
        diagnostics.splice(0..0, echoes);
        diagnostics.append(&mut structural.notes());
        let scene = result.ok().filter(|_| !failed).map(|shown| shown.with(parameters));
        return Evaluation { scene, diagnostics };
    }
}

/// Where a diagnostic stands in the order of the text.
fn place(diagnostic: &Diagnostic) -> Option<(FileId, u32)> {
    diagnostic.span.map(|span| (span.file, span.start))
}

fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

/// That a number has to be known which no parameter explains. A number that was asked for is live, so that this is
/// never said; but a scene must not lack a part silently.
fn unknown_number(demotion: &Demotion) -> Diagnostic {
    Diagnostic::error(demotion.span, "this number has to be known here").with_label(demotion.reason)
}

/// Parses the definitions from outside. Each becomes a file of its own, so that messages can point into it.
fn definitions(sources: &mut Sources, options: &Options, diagnostics: &mut Vec<Diagnostic>) -> Vec<Definition> {
    let mut definitions = Vec::new();
    for (name, value) in &options.definitions {
        let text = format!("{name} = {value};");
        let id = sources.add(SourceFile::new(format!("-D {name}"), text.clone()));
        let (mut tree, reports) = parse(id, &text, Default::default());
        let is_broken = !reports.is_empty();
        diagnostics.extend(reports);
        match tree.statements.pop() {
            Some(Statement::Assignment(assignment))
                if tree.statements.is_empty() && *assignment.name.node == **name && !is_broken =>
            {
                let span = assignment.span;
                definitions.push(Definition { name: name.clone(), value: assignment.value, span });
            }
            _ => {
                let message = format!("`{name}` can't be set to `{value}`, which is not one value");
                diagnostics.push(Diagnostic::error(Span::new(id, 0..text.len()), message));
            }
        }
    }
    definitions
}

/// What there is to see of a scene.
struct Shown {
    root: Arc<Solid>,
    lights: Vec<PlacedLight>,
    camera: Camera,
}

impl Shown {
    fn with(self, parameters: Vec<LiveParameter>) -> Scene {
        Scene { root: self.root, lights: self.lights, camera: self.camera, parameters }
    }
}

impl<'t> Evaluator<'t> {
    fn scene(&mut self, definitions: &'t [Definition]) -> Result<Shown> {
        self.default_specials();
        let main = &self.library.files[0];
        let id = self.plan_id(&main.tree.statements);
        let plan = self.plan(id);
        let scope = Rc::new(Scope::outermost(Some(id)));
        self.top_level(&plan, definitions, &scope)?;
        let from_variables = self.camera(&plan, definitions);
        let children = self.instances(&plan, &scope, None)?;
        let built = self.union(children, Span::new(main.id, 0..0));
        let aside = std::mem::take(&mut self.aside);
        let camera = self.placed_camera(&aside.cameras, from_variables);
        let (root, lights) = match self.root.take() {
            Some(root) => (root.solid, root.lights),
            None => (built.solid, aside.lights),
        };
        self.check_environments(&lights);
        self.check_darkness(&root, &lights);
        Ok(Shown { root, lights, camera })
    }

    /// The last camera that is placed; what it leaves open is as variables say.
    fn placed_camera(&mut self, cameras: &[PlacedCamera], from_variables: Camera) -> Camera {
        let Some((last, others)) = cameras.split_last() else { return from_variables };
        if let Some(first) = others.first() {
            let message = "the scene has several cameras: the last one counts";
            self.warn(Diagnostic::warning(last.span, message).with_related(first.span, "the first one"));
        }
        let PlacedCamera { eye, target, field_of_view, .. } = last.clone();
        Camera {
            eye: Some(eye),
            target: Some(target),
            rotation: None,
            distance: None,
            field_of_view: field_of_view.or(from_variables.field_of_view),
        }
    }

    /// Says that there is only one environment.
    fn check_environments(&mut self, lights: &[PlacedLight]) {
        let mut environments =
            lights.iter().filter(|placed| matches!(placed.light.emitter, Emitter::Environment { .. }));
        if let (Some(first), Some(last)) = (environments.next(), environments.next_back()) {
            let message = "the scene has several environments: the last one counts";
            self.warn(Diagnostic::warning(last.span, message).with_related(first.span, "the first one"));
        }
    }

    /// Says why a picture will be black: there is nothing to be lit, or no light.
    fn check_darkness(&mut self, root: &Solid, lights: &[PlacedLight]) {
        let Some(first) = lights.first() else { return };
        let is_sky = |placed: &PlacedLight| matches!(placed.light.emitter, Emitter::Environment { .. });
        if lights.iter().all(|placed| placed.light.is_dark()) {
            let message = "no light of this scene shines, so that its picture is black";
            let warning = Diagnostic::warning(first.span, message);
            self.warn(warning.with_hint("without any light in its text, a scene is shown in a studio"));
        } else if matches!(root.kind, SolidKind::Empty) && !lights.iter().any(is_sky) {
            let message = "there is no solid for this light to shine on, so that the picture shows nothing lit";
            self.warn(Diagnostic::warning(first.span, message));
        }
    }

    fn default_specials(&mut self) {
        let numbers = |values: &[f64]| Value::list(values.iter().copied().map(Value::number).collect());
        let defaults = [
            ("$fn", Value::number(0.0)),
            ("$fa", Value::number(12.0)),
            ("$fs", Value::number(2.0)),
            // As where OpenSCAD draws a picture or dumps a tree: many a library shows its assemblies only then.
            ("$preview", Value::Bool(true)),
            ("$vpr", numbers(&[0.0, 0.0, 0.0])),
            ("$vpt", numbers(&[0.0, 0.0, 0.0])),
            ("$vpd", Value::number(500.0)),
            ("$vpf", Value::number(22.5)),
        ];
        for (name, value) in defaults {
            self.specials.set_default(name.into(), value);
        }
    }

    /// Evaluates the scene's own variables, with values from outside instead of those in the text.
    fn top_level(&mut self, plan: &Plan<'t>, definitions: &'t [Definition], scope: &Rc<Scope>) -> Result<()> {
        let is_assigned = |name: &str| plan.assignments.iter().any(|planned| &*planned.first.name.node == name);
        for definition in definitions.iter().filter(|definition| !is_assigned(&definition.name)) {
            if !Specials::is_special(&definition.name) {
                let message = format!("the scene has no variable `{}` to set", definition.name);
                let mut error = Diagnostic::error(definition.span, message);
                let known = plan.assignments.iter().map(|planned| &*planned.first.name.node);
                let nearest = suggest::nearest(&definition.name, known);
                error.hints.extend(nearest.map(|nearest| format!("did you mean `{nearest}`?")));
                self.error(error);
                continue;
            }
            let slot = self.slot(&definition.value, scope)?;
            match (definition.name.as_str(), slot.as_ref().and_then(Value::constant)) {
                ("$t", Some(time)) => self.live.set_time(time),
                _ => self.specials.set(definition.name.as_str().into(), slot),
            }
        }
        for planned in &plan.assignments {
            let name = &planned.first.name.node;
            let outside = definitions.iter().rfind(|definition| *definition.name == **name);
            let value = outside.map_or(planned.value(), |definition| &definition.value);
            let slot = self.slot(value, scope)?.map(|value| self.live.assigned(planned.last, value));
            if Specials::is_special(name) {
                self.specials.set(name.clone(), slot);
            } else {
                scope.set(name.clone(), slot);
            }
        }
        Ok(())
    }

    /// What a variable is to stand for.
    pub(crate) fn slot(&mut self, value: &Expression, scope: &Rc<Scope>) -> Result<Slot> {
        match self.expression(value, scope) {
            Ok(value) => Ok(Some(value)),
            Err(halt) => self.set_aside(halt).map(|()| None),
        }
    }

    /// The plan of a file that is used.
    pub(crate) fn used_plan(&mut self, file: FileIndex) -> Rc<Plan<'t>> {
        let library = self.library;
        let id = self.plan_id(&library.files[file].tree.statements);
        self.plan(id)
    }

    /// A file that is used, its top level evaluated when it is first needed. OpenSCAD evaluates it anew in every call,
    /// which makes a difference only where it depends on variables that follow the calls.
    pub(crate) fn unit(&mut self, file: FileIndex) -> Result<Unit> {
        if let Some(unit) = self.units.get(&file) {
            return Ok(unit.clone());
        }
        let library = self.library;
        let id = self.plan_id(&library.files[file].tree.statements);
        let plan = self.plan(id);
        let scope = Rc::new(Scope::outermost(Some(id)));
        // Its variables may call functions of files that use it in turn: those see what is there so far.
        self.units.insert(file, Unit { scope: scope.clone(), specials: Rc::default() });
        let mark = self.specials.mark();
        let result = self.assignments(&plan, &scope);
        let names = plan.assignments.iter().map(|planned| planned.first.name.node.clone());
        let specials = names.filter(|name| Specials::is_special(name));
        let specials = specials.filter_map(|name| self.specials.get(&name).cloned().map(|slot| (name, slot))).collect();
        self.specials.restore(mark);
        result?;
        let unit = Unit { scope, specials: Rc::new(specials) };
        self.units.insert(file, unit.clone());
        Ok(unit)
    }

    /// The view that the scene's top level sets, or a definition from outside.
    fn camera(&mut self, plan: &Plan<'t>, definitions: &[Definition]) -> Camera {
        let mut camera = Camera::default();
        let own = plan.assignments.iter().map(|planned| (&*planned.first.name.node, planned.value().span));
        let is_own = |name: &str| own.clone().any(|(own, _)| own == name);
        let outside = definitions.iter().map(|definition| (definition.name.as_str(), definition.span));
        let outside = outside.filter(|(name, _)| !is_own(name));
        for (name, span) in own.clone().chain(outside) {
            match name {
                "$vpt" => camera.target = self.view_vector(name, span),
                "$vpr" => camera.rotation = self.view_vector(name, span),
                "$vpd" => camera.distance = self.view_number(name, span),
                "$vpf" => camera.field_of_view = self.view_number(name, span),
                _ => {}
            }
        }
        camera
    }

    fn view_vector(&mut self, name: &str, span: Span) -> Option<[Scalar; 3]> {
        let value = self.specials.get(&name.into())?.clone()?;
        if let Value::List(list) = &value
            && let [Value::Number(x), Value::Number(y), Value::Number(z)] = &list[..]
        {
            let numbers = [x.clone(), y.clone(), z.clone()];
            return self.are_finite(&numbers, name, span).then_some(numbers);
        }
        self.warn(Diagnostic::warning(span, format!("`{name}` takes three numbers, not {}", value.described())));
        None
    }

    fn view_number(&mut self, name: &str, span: Span) -> Option<Scalar> {
        match self.specials.get(&name.into())?.clone()? {
            Value::Number(number) => self.are_finite(std::slice::from_ref(&number), name, span).then_some(number),
            other => {
                self.warn(Diagnostic::warning(span, format!("`{name}` takes a number, not {}", other.described())));
                None
            }
        }
    }

    /// Whether numbers of the view are finite; warns if not, and asks for live ones to be known that may not be.
    fn are_finite(&mut self, numbers: &[Scalar], name: &str, span: Span) -> bool {
        let finite = numbers.iter().all(Scalar::is_finite);
        if let Some(live) = numbers.iter().find(|number| number.constant().is_none() && !number.is_finite()) {
            self.demotions.push(*Live::demotion(live.clone(), span, "a finite number"));
        } else if !finite {
            self.warn(Diagnostic::warning(span, format!("`{name}` is not finite, so that it is left open")));
        }
        finite
    }
}
