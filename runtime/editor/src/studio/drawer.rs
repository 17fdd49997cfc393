//! The thread that draws.
//!
//! Practice: a change is first drawn small, so that it shows at once; then in full, better with every sample. New orders are
//! looked at about ten times a second, between two steps of a picture.

mod canvas;
mod pace;

use std::time::{Duration, Instant};

use chiaro_render::{Error, View};

use super::{Event, Frame, Order, Shared, Subject, Wanted, guarded};
use canvas::Canvas;
use pace::Pace;

/// A picture in progress is shown this often.
const SHOWN_EVERY: Duration = Duration::from_millis(200);

/// Draws until the window is closed.
pub(crate) fn work(shared: &Shared) {
    let mut easel = Easel::default();
    while !shared.orders.is_closed() {
        let order = if easel.is_busy() { shared.orders.try_take() } else { shared.orders.take() };
        if let Some(order) = order {
            easel.accept(order);
        }
        match guarded(|| easel.work()) {
            Ok(Ok(None)) => {}
            Ok(Ok(Some(frame))) => shared.say(Event::Frame(Box::new(frame))),
            Ok(Err(error)) => {
                let is_lost = matches!(error, Error::Lost(_) | Error::Stuck(_));
                easel.give_up();
                shared.say(Event::Trouble(error.to_string()));
                if is_lost {
                    shared.reopen();
                }
            }
            Err(message) => {
                easel.give_up();
                shared.say(Event::Trouble(message));
            }
        }
    }
}

/// What the thread is at.
#[derive(Default)]
struct Easel {
    subject: Option<Subject>,
    wanted: Wanted,
    stage: Stage,
    /// From where the scene was seen first: the studio's lights stand as seen from there.
    first_view: Option<View>,
    /// The view that frames the subject.
    framing: Option<View>,
    pace: Pace,
    small: Option<Canvas>,
    full: Option<Canvas>,
    last_shown: Option<Instant>,
}

/// What is drawn next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    /// Nothing: the picture is as good as wanted.
    #[default]
    Done,
    /// A first sample, small enough to be quick.
    Small,
    /// Samples in full size.
    Full,
}

impl Easel {
    fn is_busy(&self) -> bool {
        self.stage != Stage::Done && self.subject.is_some()
    }

    /// Forgets the subject: the picture before stays in the window until another one comes.
    fn give_up(&mut self) {
        (self.subject, self.small, self.full) = (None, None, None);
        self.stage = Stage::Done;
    }

    fn accept(&mut self, order: Order) {
        if let Some(subject) = order.subject {
            (self.small, self.full, self.framing) = (None, None, None);
            self.subject = Some(subject);
            self.stage = Stage::Small;
        }
        let Some(wanted) = order.wanted else { return };
        if wanted != self.wanted {
            let only_better = Wanted { samples: self.wanted.samples, moving: self.wanted.moving, ..wanted.clone() };
            let is_same_picture = only_better == self.wanted;
            self.wanted = wanted;
            self.stage = if is_same_picture && self.stage != Stage::Small { Stage::Full } else { Stage::Small };
        }
    }

    /// Draws for about a tenth of a second. A frame, if there is something new to show.
    fn work(&mut self) -> Result<Option<Frame>, Error> {
        if self.subject.is_none() {
            return Ok(None);
        }
        match self.stage {
            Stage::Done => Ok(None),
            Stage::Small => self.draw_small().map(Some),
            Stage::Full => self.draw_full(),
        }
    }

    fn draw_small(&mut self) -> Result<Frame, Error> {
        let size = self.pace.small(self.wanted.size);
        let view = self.view()?;
        let at_hand = self.small.take();
        let mut canvas = self.canvas(at_hand, size)?;
        canvas.prepare(&self.wanted, view)?;
        let begun = Instant::now();
        canvas.sample()?;
        self.pace.note(size, begun.elapsed());
        let frame = self.frame(&canvas, begun.elapsed())?;
        self.small = Some(canvas);
        self.stage = if self.wanted.moving { Stage::Done } else { Stage::Full };
        Ok(frame)
    }

    fn draw_full(&mut self) -> Result<Option<Frame>, Error> {
        let view = self.view()?;
        let at_hand = self.full.take();
        let mut canvas = self.canvas(at_hand, self.wanted.size)?;
        canvas.prepare(&self.wanted, view)?;
        let begun = Instant::now();
        let is_complete = canvas.samples() < self.wanted.samples && canvas.step()?;
        let is_done = canvas.samples() >= self.wanted.samples;
        let is_due = canvas.samples() <= 1 || self.last_shown.is_none_or(|shown| shown.elapsed() >= SHOWN_EVERY);
        let shown = is_done || is_complete && is_due;
        let frame = if shown { Some(self.frame(&canvas, begun.elapsed())?) } else { None };
        if is_done {
            self.stage = Stage::Done;
        }
        self.full = Some(canvas);
        Ok(frame)
    }

    /// A canvas of that size: the one at hand, if it is.
    fn canvas(&self, at_hand: Option<Canvas>, size: [u32; 2]) -> Result<Canvas, Error> {
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        match at_hand.filter(|canvas| canvas.size() == size && canvas.compares() == self.wanted.other.is_some()) {
            Some(canvas) => Ok(canvas),
            None => Canvas::new(subject, size, self.first_view, &self.wanted),
        }
    }

    /// From where the subject is seen.
    fn view(&mut self) -> Result<View, Error> {
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        let view = match self.wanted.view {
            Some(view) => view,
            None => {
                let parameters = self.wanted.parameters(&subject.scene);
                let extent = subject.model.extent(&subject.gpu)?;
                let aspect = f64::from(self.wanted.size[0]) / f64::from(self.wanted.size[1]);
                *self.framing.insert(View::framing(&subject.scene.camera, &parameters, &extent, aspect))
            }
        };
        self.first_view.get_or_insert(view);
        Ok(view)
    }

    fn frame(&mut self, canvas: &Canvas, first_sample: Duration) -> Result<Frame, Error> {
        let Some(subject) = &mut self.subject else { return Err(Error::NoDriver) };
        let timings = &mut subject.timings;
        timings.sample = canvas.sample_time();
        let (rgba, other) = canvas.pixels()?;
        if let Some(asked) = timings.asked.take() {
            (timings.first_sample, timings.to_frame) = (first_sample, asked.elapsed());
        }
        self.last_shown = Some(Instant::now());
        Ok(Frame {
            revision: subject.revision,
            size: canvas.size(),
            rgba,
            other,
            view: canvas.view(),
            samples: canvas.samples(),
            timings: *timings,
        })
    }
}
