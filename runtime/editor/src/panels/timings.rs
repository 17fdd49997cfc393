//! How long each stage of the last revisions took.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use egui::{Grid, Pos2, Rect, Sense, Stroke, Ui, pos2, vec2};

use crate::app::Editor;
use crate::status::milliseconds;
use crate::studio::Timings;

/// So many revisions are remembered.
const REMEMBERED: usize = 60;
/// The height of the plot, in points.
const PLOT_HEIGHT: f32 = 90.0;
/// So many frames of the window are remembered.
const FRAMES: usize = 500;
/// The memory is looked at this often.
const MEMORY_EVERY: Duration = Duration::from_secs(1);

/// The timings of the last revisions, the newest last.
#[derive(Default)]
pub(crate) struct History {
    timings: VecDeque<Timings>,
    /// What the window's last frames took: the longer of them are when it doesn't answer.
    window: VecDeque<Duration>,
    memory: Option<(Instant, Option<u64>)>,
}

impl History {
    /// Remembers the timings of a revision, if they are new.
    pub(crate) fn note(&mut self, timings: Timings) {
        if timings.to_frame.is_zero() {
            return;
        }
        match self.timings.back_mut() {
            Some(last) if last.to_frame == timings.to_frame => *last = timings,
            _ => self.timings.push_back(timings),
        }
        while self.timings.len() > REMEMBERED {
            self.timings.pop_front();
        }
    }

    /// Remembers what a frame of the window took.
    pub(crate) fn note_window(&mut self, took: Duration) {
        if self.window.len() == FRAMES {
            self.window.pop_front();
        }
        self.window.push_back(took);
    }

    /// The bytes of memory that the process has, where the system says.
    fn memory(&mut self) -> Option<u64> {
        match self.memory {
            Some((at, bytes)) if at.elapsed() < MEMORY_EVERY => bytes,
            _ => self.memory.insert((Instant::now(), resident())).1,
        }
    }
}

/// The resident memory of this process in bytes, where there is a `/proc`.
pub(crate) fn resident() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? * 1024)
}

/// Shows them.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let timings = editor.viewport.timings;
    let history = &mut editor.panels.timings;
    stages(ui, &timings);
    ui.add_space(10.0);
    let in_milliseconds = |time: Duration| time.as_secs_f32() * 1e3;
    let times: Vec<f32> = history.timings.iter().map(|timings| in_milliseconds(timings.to_frame)).collect();
    ui.strong(format!("Key to frame, the last {}", times.len()));
    plot(ui, &times);
    if let Some([median, slow]) = quantiles(&times) {
        ui.label(format!("median {median:.0} ms, 95 of 100 below {slow:.0} ms"));
    }
    ui.add_space(10.0);
    let window: Vec<f32> = history.window.iter().copied().map(in_milliseconds).collect();
    Grid::new("facts").num_columns(2).spacing([16.0, 4.0]).show(ui, |ui| {
        if !timings.sample.is_zero() {
            row(ui, "Samples a second", &format!("{:.1}", 1.0 / timings.sample.as_secs_f64()));
        }
        row(ui, "Samples", &editor.viewport.samples().to_string());
        if let Some(shown) = &editor.session.shown {
            row(ui, "Nodes of the field", &shown.scene.graph.nodes.len().to_string());
            row(ui, "Live numbers", &shown.scene.graph.slots.len().to_string());
        }
        if let Some([median, _]) = quantiles(&window) {
            let longest = window.iter().copied().fold(0.0, f32::max);
            row(ui, "Window", &format!("{median:.0} ms, at most {longest:.0} ms"));
        }
        if let Some(bytes) = history.memory() {
            row(ui, "Memory", &format!("{:.0} MiB", bytes as f64 / f64::from(1 << 20)));
        }
        row(ui, "Device", &editor.session.device);
    });
}

fn stages(ui: &mut Ui, timings: &Timings) {
    let stages = [
        ("Text to field", timings.compile),
        ("Pipelines", timings.pipelines),
        ("First sample", timings.first_sample),
        ("Key to frame", timings.to_frame),
        ("A sample", timings.sample),
    ];
    let longest = stages.iter().map(|(_, time)| time.as_secs_f32()).fold(1e-6, f32::max);
    let right = ui.max_rect().right();
    Grid::new("stages").num_columns(3).spacing([12.0, 4.0]).show(ui, |ui| {
        for (name, time) in stages {
            ui.label(name);
            ui.monospace(milliseconds(time));
            let room = (right - ui.cursor().left()).max(0.0);
            let (rect, _) = ui.allocate_exact_size(vec2(room, 12.0), Sense::hover());
            let width = rect.width() * time.as_secs_f32() / longest;
            let bar = Rect::from_min_size(rect.min, vec2(width.max(1.0), rect.height()));
            ui.painter().rect_filled(bar, 2.0, ui.visuals().selection.bg_fill);
            ui.end_row();
        }
    });
}

fn row(ui: &mut Ui, name: &str, value: &str) {
    ui.label(name);
    // (What had to be cut is shown when the pointer rests on it.)
    ui.add(egui::Label::new(egui::RichText::new(value).monospace()).truncate());
    ui.end_row();
}

/// A line through the times, from zero to the longest.
fn plot(ui: &mut Ui, times: &[f32]) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), PLOT_HEIGHT), Sense::hover());
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 4.0, ui.visuals().extreme_bg_color);
    let longest = times.iter().copied().fold(1.0, f32::max);
    let inside = rect.shrink(6.0);
    let at = |index: usize, time: f32| -> Pos2 {
        let part = index as f32 / (REMEMBERED - 1) as f32;
        pos2(inside.left() + part * inside.width(), inside.bottom() - time / longest * inside.height())
    };
    let points: Vec<Pos2> = times.iter().enumerate().map(|(index, time)| at(index, *time)).collect();
    let stroke = Stroke::new(1.5, ui.visuals().hyperlink_color);
    for point in &points {
        painter.circle_filled(*point, 2.0, stroke.color);
    }
    painter.line(points.clone(), stroke);
    let nearest = response.hover_pos().and_then(|pointer| {
        let distance = |point: &Pos2| (point.x - pointer.x).abs();
        (0..points.len()).min_by(|a, b| distance(&points[*a]).total_cmp(&distance(&points[*b])))
    });
    if let Some(index) = nearest {
        response.on_hover_text(format!("{:.0} ms", times[index]));
    }
}

/// The median and the 95th percentile.
fn quantiles(times: &[f32]) -> Option<[f32; 2]> {
    let mut sorted = times.to_vec();
    sorted.sort_by(f32::total_cmp);
    let at =
        |part: f32| sorted.get(((sorted.len() as f32 * part) as usize).min(sorted.len().saturating_sub(1))).copied();
    Some([at(0.5)?, at(0.95)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_revision_counts_once_and_the_oldest_is_forgotten() {
        let mut history = History::default();
        let timings = |milliseconds| Timings { to_frame: Duration::from_millis(milliseconds), ..Timings::default() };
        history.note(timings(0));
        for time in 1..=100 {
            history.note(timings(time));
            history.note(timings(time));
        }
        assert_eq!(history.timings.len(), REMEMBERED);
        assert_eq!(history.timings.front(), Some(&timings(41)));
    }

    #[test]
    fn quantiles_are_of_what_was_measured() {
        let times: Vec<f32> = (0..100).map(|time| time as f32).collect();
        assert_eq!(quantiles(&times), Some([50.0, 95.0]));
        assert_eq!(quantiles(&[]), None);
        assert_eq!(quantiles(&[3.0]), Some([3.0, 3.0]));
    }
}
