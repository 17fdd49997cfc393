//! Instances of modules: control flow, the scene's own modules, and their children.

use std::rc::Rc;
use std::sync::Arc;

use chiaro_solid::{Solid, SolidKind};
use chiaro_syntax::tree::{Instance, ModuleDefinition, Name, Statement};
use chiaro_syntax::{Diagnostic, Span};

use crate::evaluator::{Call, Children, Evaluator, Halt, Result, Root, Unit};
use crate::geometry::OnlyChild;
use crate::live::Live;
use crate::plan::Plan;
use crate::scope::{Scope, Specials};
use crate::value::Value;
use crate::{foreign, geometry, suggest};

/// The modules that are part of the language rather than geometry.
pub(crate) const CONTROL: [&str; 9] =
    ["for", "intersection_for", "if", "let", "assign", "echo", "assert", "children", "child"];

/// Those of them that make no more of their children than to take them as one.
const GROUPING: [&str; 8] = ["for", "if", "let", "assign", "echo", "assert", "children", "child"];

/// The work of moving a light or a camera, in steps.
const ASIDE_STEPS: u64 = 200;

/// A solid and its depth.
#[derive(Clone)]
pub(crate) struct Built {
    pub(crate) solid: Arc<Solid>,
    pub(crate) depth: u32,
}

impl Built {
    /// A solid that is at most so deep.
    fn new(solid: Arc<Solid>, depth: u32) -> Self {
        let is_empty = matches!(solid.kind, SolidKind::Empty);
        Self { solid, depth: if is_empty { 1 } else { depth } }
    }
}

/// A module of the scene's.
struct UserModule<'t> {
    definition: &'t ModuleDefinition,
    /// The scope it is defined in.
    scope: Rc<Scope>,
    /// The file it comes from, if that is used.
    unit: Option<Unit>,
}

impl<'t> Evaluator<'t> {
    /// What the statements of a block come to, evaluated in a scope of their own.
    pub(crate) fn block(
        &mut self,
        statements: &'t [Statement],
        around: &Rc<Scope>,
        selected: Option<&[usize]>,
    ) -> Result<Vec<Built>> {
        let id = self.plan_id(statements);
        let plan = self.plan(id);
        let has_names = !(plan.assignments.is_empty() && plan.functions.is_empty() && plan.modules.is_empty());
        let scope = if has_names { Rc::new(Scope::within(around).of_block(id)) } else { around.clone() };
        self.assignments(&plan, &scope)?;
        self.instances(&plan, &scope, selected)
    }

    /// Evaluates a block's assignments.
    pub(crate) fn assignments(&mut self, plan: &Plan<'t>, scope: &Rc<Scope>) -> Result<()> {
        for assignment in &plan.assignments {
            let slot = self.slot(assignment.value(), scope)?;
            let name = assignment.first.name.node.clone();
            if Specials::is_special(&name) {
                self.specials.set(name, slot);
            } else {
                scope.set(name, slot);
            }
        }
        Ok(())
    }

    /// Evaluates a block's instances, or those of them with these numbers.
    pub(crate) fn instances(
        &mut self,
        plan: &Plan<'t>,
        scope: &Rc<Scope>,
        selected: Option<&[usize]>,
    ) -> Result<Vec<Built>> {
        let mut built = Vec::new();
        let count = selected.map_or(plan.instances.len(), <[usize]>::len);
        for at in 0..count {
            let at = selected.map_or(at, |selected| selected[at]);
            let Some(instance) = plan.instances.get(at) else { continue };
            match self.instance(instance, scope) {
                Ok(result) => built.extend(result),
                Err(halt) => self.set_aside(halt)?,
            }
        }
        Ok(built)
    }

    /// What an instance comes to: one solid at the most, or several where [`every`](Evaluator::every) of them counts.
    fn instance(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Vec<Built>> {
        self.enter(instance.head)?;
        let order = self.instances;
        self.instances += 1;
        let (mark, calls, only_hull) = (self.specials.mark(), self.calls.len(), self.only_hull);
        let every = self.every;
        // What is shown alone is not part of any hull around it.
        self.only_hull &= !instance.modifiers.root;
        let before = std::mem::take(&mut self.aside);
        let result = self.dispatched(instance, scope);
        let aside = std::mem::replace(&mut self.aside, before);
        (self.only_hull, self.every) = (only_hull, every);
        self.specials.restore(mark);
        self.calls.truncate(calls);
        self.leave();
        let made = match result? {
            Some(made) if every || made.len() == 1 => made,
            Some(made) => vec![self.union(made, instance.head)],
            None if aside.is_empty() => return Ok(Vec::new()),
            None => vec![Built::new(Solid::new(SolidKind::Empty, instance.head), 1)],
        };
        let mut built = Vec::with_capacity(made.len());
        for Built { solid, depth } in made {
            self.count_solid(instance.head)?;
            if depth > self.options.limits.solid_depth {
                let message = format!("the solids here are nested more than {} deep", self.options.limits.solid_depth);
                return Err(self.abort(Diagnostic::error(instance.head, message)));
            }
            built.push(Built { solid: solid.seen_from(instance.head), depth });
        }
        if instance.modifiers.root && self.root.as_ref().is_none_or(|first| order < first.order) {
            let solid = self.union(built.clone(), instance.head).solid;
            self.root = Some(Root { order, solid, lights: aside.lights.clone() });
        }
        if instance.modifiers.background {
            return Ok(Vec::new());
        }
        if !aside.is_empty() {
            // Where there is light and no solid, there is no operand either.
            built.retain(|built| !matches!(built.solid.kind, SolidKind::Empty));
        }
        self.aside.append(aside);
        Ok(built)
    }

    /// What an instance comes to. That of a group is still apart.
    fn dispatched(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Option<Vec<Built>>> {
        let name = &instance.name.node;
        let user_module = self.user_module(name, scope)?;
        self.every &= user_module.is_none() && GROUPING.contains(&&**name);
        if let Some(module) = user_module {
            return self.user_instance(module, instance, scope).map(Some);
        }
        match &**name {
            "for" => self.looped(instance, scope).map(Some),
            "intersection_for" => {
                let children = self.looped(instance, scope)?;
                let built = self.built_in_module(instance, "intersection", Vec::new(), children, scope)?;
                Ok(Some(vec![built]))
            }
            "if" => self.conditional(instance, scope),
            "let" => {
                let scope = self.bound_in_turn(&instance.arguments, scope)?;
                self.block(&instance.children, &scope, None).map(Some)
            }
            "assign" => self.assign(instance, scope).map(Some),
            "echo" => {
                self.echo_arguments(&instance.arguments, instance.head, scope)?;
                self.grouped(instance, scope)
            }
            "assert" => {
                self.assert(&instance.arguments, instance.head, scope)?;
                self.grouped(instance, scope)
            }
            "children" | "child" => self.given_children(instance, scope),
            _ => Ok(Some(vec![self.geometry(instance, scope)?])),
        }
    }

    /// The children, if there are any.
    fn grouped(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Option<Vec<Built>>> {
        let children = self.block(&instance.children, scope, None)?;
        Ok(if children.is_empty() { None } else { Some(children) })
    }

    fn looped(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Vec<Built>> {
        let mut all = Vec::new();
        if !instance.arguments.is_empty() {
            self.for_each(&instance.arguments, scope, instance.head, &mut |evaluator, scope| {
                all.extend(evaluator.block(&instance.children, scope, None)?);
                Ok(())
            })?;
        }
        Ok(all)
    }

    fn conditional(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Option<Vec<Built>>> {
        let Some(condition) = instance.arguments.first() else { return Ok(None) };
        let truth = self.decided(&condition.value, scope, "whether something is there at all")?;
        if !truth && instance.otherwise.is_empty() {
            return Ok(None);
        }
        let branch = if truth { &instance.children } else { &instance.otherwise };
        self.block(branch, scope, None).map(Some)
    }

    /// `assign(…)`: like `let`, but no value sees another.
    fn assign(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Vec<Built>> {
        let inner = Scope::within(scope);
        for argument in self.arguments(&instance.arguments, scope)? {
            match argument.name.map(|name| name.node) {
                Some(name) if Specials::is_special(&name) => self.specials.set(name, Some(argument.value)),
                Some(name) => inner.set(name, Some(argument.value)),
                None => self.warn(Diagnostic::warning(argument.span, "this value gets no name")),
            }
        }
        self.block(&instance.children, &Rc::new(inner), None)
    }

    /// The module of that name, if the scene defines one.
    fn user_module(&mut self, name: &Name, scope: &Rc<Scope>) -> Result<Option<UserModule<'t>>> {
        let mut next = Some(scope);
        while let Some(scope) = next {
            if let Some(plan) = scope.plan.map(|id| self.plan(id)) {
                if let Some(definition) = plan.modules.get(name) {
                    return Ok(Some(UserModule { definition, scope: scope.clone(), unit: None }));
                }
                for file in plan.uses.iter().rev() {
                    let used = self.used_plan(*file);
                    if let Some(definition) = used.modules.get(name) {
                        let unit = self.unit(*file)?;
                        return Ok(Some(UserModule { definition, scope: unit.scope.clone(), unit: Some(unit) }));
                    }
                }
            }
            next = scope.parent.as_ref();
        }
        Ok(None)
    }

    fn user_instance(
        &mut self,
        module: UserModule<'t>,
        instance: &'t Instance,
        around: &Rc<Scope>,
    ) -> Result<Vec<Built>> {
        let UserModule { definition, scope: defining, unit } = module;
        let name = &instance.name.node;
        let arguments = self.arguments(&instance.arguments, around)?;
        let specials = self.specials.mark();
        self.set_specials(unit);
        self.modules.push(name.clone());
        let depth = Value::number(self.modules.len() as f64);
        self.specials.set(self.names.parent_modules.clone(), Some(depth));
        self.children.push(Children { statements: &instance.children, scope: around.clone(), specials });
        self.calls.push(Call {
            name: name.clone(),
            site: instance.head,
            definition: std::ptr::from_ref(definition).cast(),
        });
        let children = self.body(definition, arguments, &defining);
        self.children.pop();
        self.modules.pop();
        Ok(vec![self.union(children?, instance.head)])
    }

    fn body(
        &mut self,
        definition: &'t ModuleDefinition,
        arguments: Vec<geometry::Argument>,
        defining: &Rc<Scope>,
    ) -> Result<Vec<Built>> {
        let parameters = self.bind(&definition.name.node, &definition.parameters, arguments, defining)?;
        let number = self.children.len() - 1;
        let given = self.plan_id(self.children[number].statements);
        let count = self.plan(given).instances.len();
        parameters.set(self.names.children.clone(), Some(Value::number(count as f64)));
        let id = self.plan_id(&definition.body);
        let scope = Rc::new(parameters.of_block(id).with_children(number));
        let plan = self.plan(id);
        self.assignments(&plan, &scope)?;
        self.instances(&plan, &scope, None)
    }

    /// `children(…)`: what stands in the braces behind the instance of the module that this is written in.
    fn given_children(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Option<Vec<Built>>> {
        let arguments = self.arguments(&instance.arguments, scope)?;
        let Some(number) = scope.chain().find_map(|scope| scope.children) else {
            let message = format!("`{}` has a meaning only inside a module", instance.name.node);
            return Err(self.error(Diagnostic::error(instance.head, message)));
        };
        let Some(given) = self.children.get(number).cloned() else { return Ok(None) };
        let plan = self.plan_id(given.statements);
        let count = self.plan(plan).instances.len();
        let selected = match arguments.first() {
            Some(index) => match self.child_numbers(index, count)? {
                Some(numbers) => Some(numbers),
                None => return Ok(None),
            },
            // The old `child()` is the first one.
            None if &*instance.name.node == "child" => Some(vec![0]),
            None => None,
        };
        // What the module's own file says where no caller does is not for what the caller wrote.
        let hidden = self.specials.hide(given.specials);
        let children = self.block(given.statements, &given.scope, selected.as_deref());
        self.specials.show(hidden);
        children.map(Some)
    }

    /// Which children an index means: a number, a list or a range.
    fn child_numbers(&mut self, index: &geometry::Argument, count: usize) -> Result<Option<Vec<usize>>> {
        let numbers: Vec<Value> = match &index.value {
            number @ Value::Number(_) => vec![number.clone()],
            Value::List(list) => list.to_vec(),
            Value::Range(range) => self.listed(range, index.span)?.map(Value::number).collect(),
            other => {
                let message =
                    format!("`children` takes a number, a list or a range, but this is {}", other.described());
                self.warn(Diagnostic::warning(index.span, message));
                return Ok(None);
            }
        };
        let is_single = matches!(index.value, Value::Number(_));
        let mut known = Vec::new();
        for number in numbers {
            match self.constant(&number, index.span, "which child is meant")?.map(f64::trunc) {
                Some(number) if (0.0..count as f64).contains(&number) => known.push(number as usize),
                Some(number) => {
                    let message = format!("there is no child {number}: the module was given {count} children");
                    self.warn(Diagnostic::warning(index.span, message));
                }
                None => {
                    let message = format!("a child's number is expected, not {}", number.described());
                    self.warn(Diagnostic::warning(index.span, message));
                }
            }
        }
        Ok(if is_single && known.is_empty() { None } else { Some(known) })
    }

    /// An instance of a built-in module.
    fn geometry(&mut self, instance: &'t Instance, scope: &Rc<Scope>) -> Result<Built> {
        let mut arguments = self.arguments(&instance.arguments, scope)?;
        for argument in &arguments {
            if let Some(name) = argument.name.as_ref().filter(|name| Specials::is_special(&name.node)) {
                self.specials.set(name.node.clone(), Some(argument.value.clone()));
            }
        }
        arguments.retain(|argument| argument.name.as_ref().is_none_or(|name| !Specials::is_special(&name.node)));
        let only_hull = self.only_hull;
        self.only_hull = geometry::only_hull_counts(&instance.name.node, only_hull);
        self.every = geometry::takes_every(&instance.name.node) && self.wants_every(&arguments)?;
        let children = self.block(&instance.children, scope, None)?;
        (self.only_hull, self.every) = (only_hull, false);
        self.built_in_module(instance, &instance.name.node, arguments, children, scope)
    }

    /// Whether what loops make is to count one by one.
    fn wants_every(&mut self, arguments: &[geometry::Argument]) -> Result<bool> {
        let is_it =
            |argument: &&geometry::Argument| argument.name.as_ref().is_some_and(|name| &*name.node == geometry::EVERY);
        match arguments.iter().rfind(is_it) {
            Some(geometry::Argument { value: Value::Condition(live), span, .. }) => {
                Err(Halt::Demote(Live::demotion(live.clone(), *span, "what the operands are")))
            }
            Some(argument) => Ok(argument.value.is_true()),
            None => Ok(false),
        }
    }

    /// The only child that is written of an instance, if there is one only.
    fn only_child(&mut self, instance: &'t Instance) -> Option<OnlyChild> {
        let plan = self.plan_id(&instance.children);
        match self.plan(plan).instances.as_slice() {
            [only] if GROUPING.contains(&&*only.name.node) => Some(OnlyChild::Several),
            [_] => Some(OnlyChild::Operand),
            _ => None,
        }
    }

    fn built_in_module(
        &mut self,
        instance: &'t Instance,
        name: &str,
        arguments: Vec<geometry::Argument>,
        children: Vec<Built>,
        scope: &Rc<Scope>,
    ) -> Result<Built> {
        let sides = self.sides()?;
        let depth = 1 + children.iter().map(|child| child.depth).max().unwrap_or(0);
        let children = children.into_iter().map(|child| child.solid).collect();
        self.charge(ASIDE_STEPS * self.aside.len() as u64, instance.head)?;
        let mut aside = std::mem::take(&mut self.aside);
        let call = geometry::Call {
            name,
            head: instance.head,
            arguments,
            sides,
            only_hull: self.only_hull,
            children,
            only_child: self.only_child(instance),
            aside: &mut aside,
        };
        let mut reports = Vec::new();
        let solid = geometry::build(call, &self.settings, &mut reports);
        self.aside = aside;
        reports.into_iter().for_each(|report| self.warn(report));
        match solid {
            Some(Ok(solid)) => Ok(Built::new(solid, depth)),
            Some(Err(stop)) => Err(self.stopped(stop)),
            None => Err(self.unknown_module(&instance.name.node, instance.name.span, scope)),
        }
    }

    /// `$fn`, the number of sides of curves.
    fn sides(&self) -> Result<Value> {
        match self.specials.get(&self.names.sides) {
            Some(Some(value)) => Ok(value.clone()),
            Some(None) => Err(Halt::Reported),
            None => Ok(Value::Undef),
        }
    }

    fn unknown_module(&mut self, name: &Name, span: Span, scope: &Rc<Scope>) -> Halt {
        let mut known: Vec<Name> = geometry::names().chain(CONTROL).map(Name::from).collect();
        for plan in scope.chain().filter_map(|scope| scope.plan).map(|id| self.plan(id)).collect::<Vec<_>>() {
            known.extend(plan.modules.keys().map(|name| (*name).clone()));
            for file in &plan.uses {
                known.extend(self.used_plan(*file).modules.keys().map(|name| (*name).clone()));
            }
        }
        let error = Diagnostic::error(span, format!("there is no module `{name}`"));
        let error = match (foreign::module(name), foreign::module_hint(name)) {
            (Some(ours), _) => error.with_hint(format!("it is called `{ours}` here")).with_suggestion(span, ours),
            (None, Some(hint)) => error.with_hint(hint),
            (None, None) => suggest::with_nearest(error, span, name, known.iter().map(|name| &**name)),
        };
        self.error(error)
    }

    /// Several solids as one.
    pub(crate) fn union(&mut self, children: Vec<Built>, span: Span) -> Built {
        let depth = children.iter().map(|child| child.depth).max().unwrap_or(0);
        let solids: Vec<Arc<Solid>> = children.into_iter().map(|child| child.solid).collect();
        if solids.is_empty() {
            return Built::new(Solid::new(SolidKind::Empty, span), 1);
        }
        let mut reports = Vec::new();
        let single = (solids.len() == 1).then(|| solids[0].clone());
        let solid = geometry::union_of(solids, span, &mut reports);
        reports.into_iter().for_each(|report| self.warn(report));
        let is_same = single.is_some_and(|single| Arc::ptr_eq(&single, &solid));
        Built::new(solid, if is_same { depth } else { depth + 1 })
    }
}
