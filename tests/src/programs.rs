//! Programs of the scene language, made of bytes by its grammar.
//!
//! The bytes decide at each place which rule of the grammar comes next; where they end, the shortest one does. So a fuzzer
//! that changes bytes changes programs a little, and random bytes make random programs. [`scene`] minds what is of which
//! kind, so that most of its programs compile to something; [`wild`] puts anything anywhere.

use arbitrary::Unstructured;
use chiaro_compiler::vocabulary::{Kind, Row, Type, Unit, rows};

/// What stands before the statements: live parameters, and functions and a module to call.
const HEAD: &str = "p = 2; // [1:0.5:9]\n\
    q = [4, 1, 3]; // [1:9]\n\
    x = 1;\n\
    function f(x) = x <= 0 ? 0 : f(x - 1) + 1;\n\
    function g(a, b) = a > b ? a : b;\n\
    module m(x = 1) { translate([x, 0, 0]) children(); children(0); }\n";

/// How deep expressions and trees of modules are at most.
const DEPTH: u32 = 4;

/// A program of solids whose values are of the right kinds. Nearly all compile, and most have something to see.
pub fn scene(bytes: &mut Unstructured) -> String {
    program(Maker { bytes, wild: false })
}

/// A program that may do anything, most of all mistakes.
pub fn wild(bytes: &mut Unstructured) -> String {
    program(Maker { bytes, wild: true })
}

fn program(mut maker: Maker) -> String {
    let count = 1 + maker.below(3);
    (0..count).fold(HEAD.to_owned(), |text, _| text + &maker.solid(DEPTH) + "\n")
}

/// A program in the making.
struct Maker<'a, 'b> {
    bytes: &'a mut Unstructured<'b>,
    wild: bool,
}

/// A rule of the grammar, with the depth that is left.
type Rule = fn(&mut Maker, u32) -> String;

const NUMBER: Rule = |maker, depth| maker.number(depth);
const SIZE: Rule = |maker, depth| maker.size(depth);
const SOLID: Rule = |maker, depth| maker.solid(depth);
const PLANE: Rule = |maker, depth| maker.plane(depth);

impl Maker<'_, '_> {
    /// A number below `count`, which is at most 256; 0 where the bytes end.
    fn below(&mut self, count: usize) -> usize {
        self.bytes.int_in_range(0..=count - 1).unwrap_or(0)
    }

    fn one_of<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }

    /// One of these rules with less depth left, or the first where none is left.
    fn rule(&mut self, depth: u32, rules: &[Rule]) -> String {
        if depth == 0 {
            return rules[0](self, 0);
        }
        self.one_of(rules)(self, depth - 1)
    }

    fn several(&mut self, least: usize, most: usize, mut one: impl FnMut(&mut Self) -> String) -> Vec<String> {
        let count = least + self.below(most - least + 1);
        (0..count).map(|_| one(self)).collect()
    }

    /// A number from −16 to 16 with few digits, so that equal ones and zero are common.
    fn literal(&mut self) -> String {
        let eighths = self.below(256) as f64 - 128.0;
        (if self.below(2) == 0 { (eighths / 8.0).round() } else { eighths / 8.0 }).to_string()
    }

    fn number(&mut self, depth: u32) -> String {
        if self.wild && self.below(3) == 0 {
            return self.anything(depth);
        }
        self.rule(
            depth,
            &[
                |maker, _| maker.literal(),
                |maker, _| maker.literal(),
                |maker, _| maker.one_of(&["p", "q[0]", "q[2]", "x", "$t", "PI", "len(q)"]).to_owned(),
                |maker, depth| {
                    let (a, b) = (maker.number(depth), maker.number(depth));
                    format!("({a} {} {b})", maker.one_of(&["+", "-", "*"]))
                },
                |maker, depth| {
                    let function = maker.one_of(&["sin", "cos", "abs", "floor", "round", "sign", "-", "atan"]);
                    format!("{function}({})", maker.number(depth))
                },
                |maker, depth| {
                    let [a, b, c] = [(); 3].map(|()| maker.number(depth));
                    format!("({a} < {b} ? {b} : {c})")
                },
                |maker, depth| {
                    let (a, b) = (maker.number(depth), maker.number(depth));
                    format!("{}({a}, {b})", maker.one_of(&["g", "min", "max"]))
                },
                |maker, depth| {
                    let value = maker.number(depth);
                    format!("(let (x = {value}) {})", maker.number(depth))
                },
            ],
        )
    }

    /// A number above zero.
    fn size(&mut self, depth: u32) -> String {
        if self.wild && self.below(3) == 0 {
            return self.anything(depth);
        }
        match self.below(6) {
            0..=2 => ((1 + self.below(64)) as f64 / 4.0).to_string(),
            3 => (1 + self.below(12)).to_string(),
            4 => self.one_of(&["p", "q[0]", "q[1]", "(p + q[2])", "(2 * p)"]).to_owned(),
            _ => format!("(abs({}) + 0.5)", self.number(depth.saturating_sub(1))),
        }
    }

    fn list(&mut self, count: usize, depth: u32, one: Rule) -> String {
        let numbers: Vec<String> = (0..count).map(|_| one(self, depth)).collect();
        format!("[{}]", numbers.join(", "))
    }

    /// A point or direction in space.
    fn vector(&mut self, depth: u32) -> String {
        if self.wild && self.below(3) == 0 {
            return self.anything(depth);
        }
        self.list(3, depth.saturating_sub(2), NUMBER)
    }

    /// Any value at all, right or wrong.
    fn anything(&mut self, depth: u32) -> String {
        const LEAVES: [&str; 22] = [
            "1",
            "-2.5",
            "1e300",
            "0",
            "p",
            "q",
            "q[0]",
            "$t",
            "true",
            "undef",
            "\"aß\"",
            "[]",
            "[1, 2, 3]",
            "[0 : 3]",
            "x",
            "PI",
            "1 / 0",
            "0 / 0",
            "function(x) x + 1",
            "$fn",
            "$children",
            "[[1, 2], [3, 4]]",
        ];
        const OPERATORS: [&str; 14] = ["+", "-", "*", "/", "%", "^", "<", "<=", "==", "!=", "&&", "||", "&", "<<"];
        const FUNCTIONS: [&str; 14] = [
            "sin", "abs", "floor", "len", "str", "min", "max", "norm", "chr", "ord", "is_num", "is_undef", "f",
            "concat",
        ];
        const OF_TWO: [&str; 9] = ["lookup", "search", "cross", "atan2", "pow", "max", "concat", "g", "log"];
        self.rule(
            depth,
            &[
                |maker, _| maker.one_of(&LEAVES).to_owned(),
                |maker, depth| maker.join(depth, |[a, b, _], operator| format!("({a} {operator} {b})"), &OPERATORS),
                |maker, depth| maker.join(depth, |[a, ..], operator| format!("({operator}{a})"), &["-", "!", "~", "+"]),
                |maker, depth| maker.join(depth, |[a, ..], function| format!("{function}({a})"), &FUNCTIONS),
                |maker, depth| maker.join(depth, |[a, b, _], function| format!("{function}({a}, {b})"), &OF_TWO),
                |maker, depth| maker.join(depth, |[a, b, c], _| format!("({a} ? {b} : {c})"), &[""]),
                |maker, depth| maker.join(depth, |[a, b, _], _| format!("({a})[{b}]"), &[""]),
                |maker, depth| maker.join(depth, |[a, b, _], _| format!("[for (x = {a}) if ({b}) x, each {b}]"), &[""]),
                |maker, depth| maker.join(depth, |[a, b, _], _| format!("let (x = {a}) {b}"), &[""]),
                |maker, depth| maker.join(depth, |[a, b, _], _| format!("({a})({b})"), &[""]),
                |maker, depth| maker.join(depth, |[a, b, _], _| format!("[{a}, {b}]"), &[""]),
            ],
        )
    }

    /// An expression of up to three others and a word.
    fn join(&mut self, depth: u32, form: fn([String; 3], &str) -> String, words: &[&str]) -> String {
        let word = self.one_of(words);
        let operands = [(); 3].map(|()| self.anything(depth));
        form(operands, word)
    }

    /// Statements that make solids.
    fn solid(&mut self, depth: u32) -> String {
        if self.wild && self.below(8) == 0 {
            let module = self.one_of(&["children", "echo", "m", "nothing", "square", "x =", "assert", "light"]);
            return format!("{module} ({});", self.anything(depth));
        }
        self.rule(
            depth,
            &[
                |maker, _| maker.simple_solid(),
                |maker, depth| maker.moved(depth, SOLID),
                |maker, depth| maker.boolean(depth, SOLID),
                |maker, depth| maker.boolean(depth, SOLID),
                |maker, depth| maker.control(depth, SOLID),
                |maker, depth| maker.turned(depth),
                |maker, depth| maker.extruded(depth),
                |maker, depth| maker.bent(depth),
                |maker, depth| maker.wrapped(depth),
                |maker, depth| maker.coloured(depth),
            ],
        )
    }

    /// A solid that everything can be done to.
    fn plain_solid(&mut self) -> String {
        if self.below(2) == 0 {
            return format!("sphere({});", self.size(1));
        }
        let size = self.list(3, 1, SIZE);
        format!("cube({size}, center = {});", self.one_of(&["true", "false"]))
    }

    fn simple_solid(&mut self) -> String {
        match self.below(6) {
            0 | 1 => self.plain_solid(),
            2 => {
                let [h, bottom] = [(); 2].map(|()| self.size(1));
                let top = self.one_of(&["0", "1", "4", "p"]);
                format!("cylinder(h = {h}, r1 = {bottom}, r2 = {top});")
            }
            3 => format!("cube({}, r = 0.5);", self.size(1)),
            _ => self.row(Kind::Solid),
        }
    }

    /// A shape of the vocabulary's table.
    fn row(&mut self, kind: Kind) -> String {
        let all: Vec<&Row> = rows().iter().copied().filter(|row| row.module && row.kind == kind).collect();
        let row = self.one_of(&all);
        let argument = |maker: &mut Self, unit: Unit| match unit {
            Unit::Size => maker.size(1),
            Unit::Length | Unit::Direction => maker.literal(),
            Unit::Angle => (10 + maker.below(36) * 10).to_string(),
            Unit::Number => (3 + maker.below(5)).to_string(),
        };
        let arguments: Vec<String> = row
            .parameters
            .iter()
            .map(|parameter| {
                let value = match parameter.ty {
                    Type::Float => argument(self, parameter.unit),
                    ty => {
                        let numbers: Vec<String> = (0..ty.len()).map(|_| argument(self, parameter.unit)).collect();
                        format!("[{}]", numbers.join(", "))
                    }
                };
                format!("{} = {value}", parameter.name)
            })
            .collect();
        let shape = format!("{}({});", row.name, arguments.join(", "));
        if row.name == "ring" {
            return format!("ring(outer = {}, inner = 0.25);", self.size(1));
        }
        // Two of them go on for ever.
        if ["gyroid", "half_space"].contains(&row.name) {
            return format!("intersection() {{ {shape} cube({}, center = true); }}", self.size(1));
        }
        shape
    }

    fn moved(&mut self, depth: u32, inner: Rule) -> String {
        let head = match self.below(8) {
            0..=2 => format!("translate({})", self.vector(depth)),
            3 => format!("rotate({})", self.number(depth)),
            4 => {
                let factor = self.one_of(&["0.5", "2", "[1, 2, 0.5]", "[-1, 1, 1]", "p", "[1, p, 1]"]);
                format!("scale({factor})")
            }
            5 => format!("mirror([1, {}, 0])", self.literal()),
            6 => format!("multmatrix([[1, {}, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])", self.literal()),
            _ => format!("m({})", self.number(depth)),
        };
        format!("{head} {{ {} }}", self.block(depth, inner))
    }

    fn block(&mut self, depth: u32, inner: Rule) -> String {
        self.several(1, 2, |maker| inner(maker, depth)).join(" ")
    }

    fn boolean(&mut self, depth: u32, inner: Rule) -> String {
        let operation = self.one_of(&["union", "difference", "intersection"]);
        let joint = match self.below(4) {
            0 | 1 => String::new(),
            2 => format!("r = {}", self.size(1)),
            _ => format!("r = {}, joint = {}", self.size(1), self.one_of(&["\"chamfer\"", "\"smooth\"", "\"fillet\""])),
        };
        format!("{operation}({joint}) {{ {} }}", self.several(2, 3, |maker| inner(maker, depth)).join(" "))
    }

    /// Statements that decide what is made, and how often.
    fn control(&mut self, depth: u32, inner: Rule) -> String {
        match self.below(5) {
            0 => format!("for (x = [0 : {}]) {{ {} }}", self.below(3), self.block(depth, inner)),
            1 => format!("for (x = {}) {{ {} }}", self.list(2, 1, NUMBER), self.block(depth, inner)),
            2 => {
                let [a, b] = [(); 2].map(|()| self.number(depth));
                let [then, other] = [(); 2].map(|()| self.block(depth, inner));
                format!("if ({a} < {b}) {{ {then} }} else {{ {other} }}")
            }
            3 => format!("let (x = {}) {{ {} }}", self.number(depth), self.block(depth, inner)),
            _ => format!("intersection_for (x = [1, 2]) {{ {} }}", self.block(depth, inner)),
        }
    }

    fn turned(&mut self, depth: u32) -> String {
        let angles = self.vector(depth);
        let axis = self.one_of(&["", "", ", v = [1, 1, 0]"]);
        let angles = if axis.is_empty() { angles } else { self.number(depth) };
        format!("rotate({angles}{axis}) {{ {} }}", self.block(depth, SOLID))
    }

    /// A solid of a plane shape.
    fn extruded(&mut self, depth: u32) -> String {
        let plane = self.plane(depth);
        match self.below(5) {
            0 | 1 => format!("linear_extrude({}) {plane}", self.size(1)),
            2 => {
                let (height, twist) = (self.size(1), self.number(1));
                format!("linear_extrude({height}, twist = {twist}, scale = {}) {plane}", self.size(1))
            }
            3 => format!("rotate_extrude() {{ translate([12, 0]) intersection() {{ circle(11); {plane} }} }}"),
            _ => {
                let angle = 10 + self.below(35) * 10;
                format!("rotate_extrude({angle}) intersection() {{ {plane} translate([0, -20]) square(40); }}")
            }
        }
    }

    /// A solid that other than a matrix changes.
    fn bent(&mut self, depth: u32) -> String {
        match self.below(5) {
            0 | 1 => format!("twist({}) {{ {} }}", self.literal(), self.block(depth, SOLID)),
            2 => format!("round({}) {}", self.size(0), self.plain_solid()),
            3 => format!("shell({}) {}", self.size(0), self.plain_solid()),
            _ => format!("resize({}) {}", self.list(3, 0, SIZE), self.plain_solid()),
        }
    }

    /// Hulls and sums.
    fn wrapped(&mut self, depth: u32) -> String {
        match self.below(3) {
            0 => {
                let ball = |maker: &mut Self| format!("translate({}) sphere({});", maker.vector(depth), maker.size(1));
                format!("hull() {{ {} }}", self.several(1, 4, ball).join(" "))
            }
            1 => {
                let block = |maker: &mut Self| {
                    let place = maker.list(3, 0, |maker, _| maker.literal());
                    format!("translate({place}) cube({});", 1 + maker.below(9))
                };
                format!("hull() {{ {} }}", self.several(1, 3, block).join(" "))
            }
            _ => format!("minkowski() {{ cube({}); sphere({}); }}", self.size(1), self.size(1)),
        }
    }

    fn coloured(&mut self, depth: u32) -> String {
        let color = match self.below(3) {
            0 => {
                self.one_of(&["\"red\"", "\"#3af\"", "\"gold\", metallic = 1", "\"white\", roughness = 0.3"]).to_owned()
            }
            1 => "[0.2, p / 9, 1]".to_owned(),
            _ => format!("[{}, 0.5, 0.25, 1]", self.below(3) as f64 / 2.0),
        };
        format!("color({color}) {{ {} }}", self.block(depth, SOLID))
    }

    /// A statement that makes a plane shape.
    fn plane(&mut self, depth: u32) -> String {
        self.rule(
            depth,
            &[
                |maker, _| maker.simple_plane(),
                |maker, depth| maker.boolean(depth, PLANE),
                |maker, depth| {
                    let place = maker.list(2, depth.saturating_sub(2), NUMBER);
                    format!("translate({place}) {{ {} }}", maker.plane(depth))
                },
                |maker, depth| format!("rotate({}) {{ {} }}", maker.number(depth), maker.plane(depth)),
                |maker, depth| {
                    let amount = maker.one_of(&["r = 1", "r = -0.5", "delta = 1", "delta = 0.5, chamfer = true"]);
                    format!("offset({amount}) {{ {} }}", maker.plane(depth))
                },
                |maker, _| format!("projection(cut = true) {{ {} }}", maker.plain_solid()),
                |maker, depth| format!("hull() {{ {} {} }}", maker.plane(depth), maker.simple_plane()),
                |maker, depth| maker.control(depth, PLANE),
            ],
        )
    }

    fn simple_plane(&mut self) -> String {
        match self.below(5) {
            0 => format!("circle({});", self.size(1)),
            1 => format!("square({}, center = {});", self.list(2, 1, SIZE), self.one_of(&["true", "false"])),
            2 => format!("circle({}, $fn = {});", self.size(0), 3 + self.below(8)),
            3 => {
                let corner = |maker: &mut Self| maker.list(2, 0, |maker, _| maker.literal());
                format!("polygon([{}]);", self.several(3, 7, corner).join(", "))
            }
            _ => self.row(Kind::Plane),
        }
    }
}
