//! Loops and variables as people write them: naga's writer declares all variables above, gives each value that it reads from one
//! a name, and knows loops of one kind.

/// The text of a function, with `for` where loops count, and variables declared where they start.
pub(super) fn as_written(function: &str) -> String {
    let mut lines: Vec<String> = function.lines().map(str::to_owned).collect();
    inline_reads(&mut lines);
    count_loops(&mut lines);
    join_declarations(&mut lines);
    let text = lines.join("\n") + "\n";
    text.replace("{\n\n", "{\n")
}

/// Puts variables in the place of the names of what was read from them, as far as they keep that value.
fn inline_reads(lines: &mut Vec<String>) {
    let variables: Vec<String> = lines.iter().filter_map(|line| declared(line)).map(str::to_owned).collect();
    let mut at = 0;
    while at < lines.len() {
        let read = read_of(&lines[at]).filter(|(_, variable)| variables.iter().any(|own| own == variable));
        match read.map(|(name, variable)| (name.to_owned(), variable.to_owned())) {
            Some((name, variable)) if keeps_value(lines, at, &name, &variable) => {
                lines.remove(at);
                lines[at..].iter_mut().for_each(|line| *line = with_word(line, &name, &variable));
            }
            _ => at += 1,
        }
    }
}

/// Whether a variable has the value that a line names until that name is mentioned for the last time.
fn keeps_value(lines: &[String], read: usize, name: &str, variable: &str) -> bool {
    let behind = || lines.iter().enumerate().skip(read + 1);
    let last = behind().filter(|(_, line)| mentions(line, name)).map(|(at, _)| at).next_back();
    let stored = behind().find(|(_, line)| assigned(line).is_some_and(|(own, _)| own == variable));
    match (last, stored) {
        (Some(last), Some((stored, _))) => last <= stored && !is_repeated(lines, read, stored),
        _ => true,
    }
}

/// Whether a line is in a loop that another one before it is not in.
fn is_repeated(lines: &[String], before: usize, at: usize) -> bool {
    let mut depth = indent(&lines[at]);
    (before + 1..at).rev().filter(|line| !lines[*line].trim().is_empty()).any(|line| {
        let encloses = indent(&lines[line]) < depth;
        depth = depth.min(indent(&lines[line]));
        encloses && lines[line].trim() == "loop {"
    })
}

/// Makes `for` of loops that leave where a variable has come to a bound, and end by adding to it.
fn count_loops(lines: &mut Vec<String>) {
    let mut at = 0;
    while at < lines.len() {
        if let Some(counted) = Counted::of(lines, at) {
            counted.rewrite(lines);
        }
        at += 1;
    }
}

/// Where the parts of a loop that counts are.
struct Counted {
    declaration: usize,
    start: usize,
    head: usize,
    /// The line of `continuing`, two before the closing brace.
    end: usize,
    text: String,
}

impl Counted {
    fn of(lines: &[String], head: usize) -> Option<Self> {
        let line = |at: usize| lines.get(at).map(|line| line.trim());
        let condition = line(head + 1)?.strip_prefix("if (")?.strip_suffix(") {")?;
        let leaves = line(head)? == "loop {" && line(head + 2)? == "break;" && line(head + 3)? == "}";
        let (variable, bound) = condition.split_once(" >= ").filter(|_| leaves)?;
        let closing = (head + 1..lines.len()).find(|at| indent(&lines[*at]) == indent(&lines[head]))?;
        let end = closing.checked_sub(3)?;
        let (added_to, sum) = assigned(lines.get(end + 1)?)?;
        let step = sum.strip_prefix(variable)?.strip_prefix(" + ")?;
        let start = (0..head).rev().find(|at| assigned(&lines[*at]).is_some_and(|(own, _)| own == variable))?;
        let (_, first) = assigned(&lines[start])?;
        let declaration = (0..start).find(|at| declared(&lines[*at]) == Some(variable))?;
        let is_whole = line(end)? == "continuing {" && added_to == variable;
        let is_local = lines[closing..].iter().all(|line| !mentions(line, variable))
            && lines[start + 1..head].iter().all(|line| !mentions(line, variable));
        let text = format!(
            "{}for (var {variable} = {first}; {variable} < {bound}; {variable} += {step}) {{",
            " ".repeat(indent(&lines[head]))
        );
        (is_whole && is_local).then_some(Self { declaration, start, head, end, text })
    }

    fn rewrite(self, lines: &mut Vec<String>) {
        lines.drain(self.end..self.end + 3);
        lines.splice(self.head..self.head + 4, [self.text]);
        lines.remove(self.start);
        lines.remove(self.declaration);
    }
}

/// Declares variables where they get their first value, if they are of use within that block alone.
fn join_declarations(lines: &mut Vec<String>) {
    let mut at = 0;
    while at < lines.len() {
        let Some(variable) = declared(&lines[at]).map(str::to_owned) else {
            at += 1;
            continue;
        };
        let mentioned = (at + 1..lines.len()).find(|line| mentions(&lines[*line], &variable));
        let first = mentioned.filter(|first| {
            let stores = assigned(&lines[*first]).is_some_and(|(own, value)| own == variable && !mentions(value, own));
            let depth = indent(&lines[*first]);
            let end =
                (*first..lines.len()).find(|line| !lines[*line].trim().is_empty() && indent(&lines[*line]) < depth);
            stores && lines[end.unwrap_or(lines.len())..].iter().all(|line| !mentions(line, &variable))
        });
        match first {
            Some(first) => {
                let indent = indent(&lines[first]);
                lines[first].insert_str(indent, "var ");
                lines.remove(at);
            }
            None => at += 1,
        }
    }
}

/// The variable that a line declares without a value.
fn declared(line: &str) -> Option<&str> {
    let (name, ty) = line.trim().strip_prefix("var ")?.strip_suffix(';')?.split_once(": ")?;
    (!ty.contains('=')).then_some(name)
}

/// A name that naga gave, and the value of that name, if the line gives one to a word.
fn read_of(line: &str) -> Option<(&str, &str)> {
    let (name, value) = line.trim().strip_prefix("let ")?.strip_suffix(';')?.split_once(" = ")?;
    (name.starts_with("_e") && value.chars().all(is_part)).then_some((name, value))
}

/// The variable that a line stores something in, and what.
fn assigned(line: &str) -> Option<(&str, &str)> {
    let (name, value) = line.trim().strip_suffix(';')?.split_once(" = ")?;
    name.chars().all(is_part).then_some((name, value))
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

fn is_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// Where a word stands in a line.
fn places<'t>(line: &'t str, word: &'t str) -> impl Iterator<Item = usize> {
    line.match_indices(word).map(|(at, _)| at).filter(move |at| {
        let is_bounded = |c: Option<char>| !c.is_some_and(is_part);
        is_bounded(line[..*at].chars().next_back()) && is_bounded(line[at + word.len()..].chars().next())
    })
}

fn mentions(line: &str, word: &str) -> bool {
    places(line, word).next().is_some()
}

/// The line with another word in the place of one.
fn with_word(line: &str, word: &str, other: &str) -> String {
    let mut result = String::with_capacity(line.len());
    let mut done = 0;
    for at in places(line, word) {
        result += &line[done..at];
        result += other;
        done = at + word.len();
    }
    result + &line[done..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_that_count_are_for() {
        let written = "fn least(p: vec3<f32>) -> f32 {
    var row: u32;
    var state: f32;

    row = 0u;
    state = 1e15;
    loop {
        let _e5 = row;
        if (_e5 >= 21u) {
            break;
        }
        let _e7 = state;
        let place = tables[_e5];
        state = min(_e7, sd_sphere(p - place.xyz, 1.7));
        continuing {
            let _e9 = row;
            row = _e9 + 1u;
        }
    }
    let _e18 = state;
    return _e18;
}
";
        let expected = "fn least(p: vec3<f32>) -> f32 {
    var state = 1e15;
    for (var row = 0u; row < 21u; row += 1u) {
        let place = tables[row];
        state = min(state, sd_sphere(p - place.xyz, 1.7));
    }
    return state;
}
";
        assert_eq!(as_written(written), expected);
    }

    #[test]
    fn what_changes_keeps_its_name() {
        let written = "fn f() -> f32 {
    var a: f32;

    a = 1.0;
    let _e1 = a;
    a = 2.0;
    let _e2 = a;
    loop {
        if (_e2 >= 3.0) {
            break;
        }
        a = 4.0;
    }
    return _e1 + _e2;
}
";
        let expected = written.replace("    var a: f32;\n\n    a = 1.0", "    var a = 1.0");
        assert_eq!(as_written(written), expected);
    }
}
