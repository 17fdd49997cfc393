//! The thread that draws.
//!
//! Practice: a change is first drawn small, so that it shows at once; then in full, better with every sample. New orders are
//! looked at about ten times a second, between two steps of a picture.

mod canvas;
mod highlight;
mod inspection;
mod pace;

use std::time::{Duration, Instant};

use chiaro_render::{Error, Inspection, Legend, Mask, Model, View};

use super::{Event, Eye, Frame, Look, Order, Outlined, Shared, Subject, Wanted, guarded};
use canvas::Canvas;
use inspection::Inspecting;
use pace::Pace;

/// A picture in progress is shown this often.
const SHOWN_EVERY: Duration = Duration::from_millis(200);

/// Draws until the window is closed.
pub(crate) fn work(shared: &Shared) {
    let mut easel = Easel::default();
    // The revision that lost the device last: what does it twice would do it for ever.
    let mut lost_by = None;
    while !shared.orders.is_closed() {
        let order = if easel.is_busy() { shared.orders.try_take() } else { shared.orders.take() };
        if let Some(order) = order {
            easel.accept(order);
        }
        let drawn = guarded(|| {
            #[cfg(test)]
            shared.sabotage.work()?;
            easel.work(&|| shared.orders.is_empty())
        });
        match drawn {
            Ok(Ok(None)) => {}
            Ok(Ok(Some(frame))) => shared.say(Event::Frame(Box::new(frame))),
            Ok(Err(error)) => {
                let is_lost = matches!(error, Error::Lost(_) | Error::Stuck(_));
                let revision = easel.subject.as_ref().map(|subject| subject.revision);
                easel.give_up();
                shared.say(Event::Trouble(error.to_string()));
                if is_lost {
                    shared.reopen(lost_by != revision);
                    lost_by = revision;
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
    /// What is outlined changed since the last frame.
    outline_is_due: bool,
    /// From where the scene was seen first: the studio's lights stand as seen from there.
    first_view: Option<View>,
    /// The view that frames the subject.
    framing: Option<(Eye, Vec<f64>, View)>,
    pace: Pace,
    inspected_pace: Pace,
    /// What looks at the subject, once something but light was asked for.
    inspecting: Option<Inspecting>,
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
        self.stage != Stage::Done && self.subject.is_some() && self.wanted.samples > 0
    }

    /// Forgets the subject: the picture before stays in the window until another one comes.
    fn give_up(&mut self) {
        (self.subject, self.small, self.full, self.inspecting) = (None, None, None, None);
        self.stage = Stage::Done;
    }

    fn accept(&mut self, order: Order) {
        if let Some(subject) = order.subject {
            self.adopt(subject);
        }
        let Some(wanted) = order.wanted else { return };
        if wanted != self.wanted {
            let is_same_picture = wanted.eye == self.wanted.eye && wanted.shows_like(&self.wanted);
            let over = |wanted: &Wanted| (wanted.outlined.clone(), wanted.highlighted.clone());
            self.outline_is_due |= over(&wanted) != over(&self.wanted);
            self.wanted = wanted;
            self.stage = if is_same_picture && self.stage != Stage::Small { Stage::Full } else { Stage::Small };
        }
    }

    /// Goes on with a subject: with the picture of the one before, if only places of the text changed.
    fn adopt(&mut self, subject: Subject) {
        let is_same_picture = self.subject.as_ref().is_some_and(|before| before.is_drawn_like(&subject));
        if is_same_picture {
            self.small.iter_mut().chain(&mut self.full).for_each(|canvas| canvas.adopt(&subject));
        } else {
            (self.small, self.full, self.inspecting) = (None, None, None);
        }
        let is_full = is_same_picture && self.full.is_some() && !self.wanted.moving;
        self.stage = if is_full && self.stage != Stage::Small { Stage::Full } else { Stage::Small };
        self.framing = None;
        self.subject = Some(subject);
    }

    /// Draws for about a tenth of a second. A frame, if there is something new to show. What takes longer is given up when it
    /// need not go on.
    fn work(&mut self, goes_on: &dyn Fn() -> bool) -> Result<Option<Frame>, Error> {
        if !self.is_busy() {
            return Ok(None);
        }
        let drawn = match (self.stage, self.wanted.look) {
            (Stage::Done, _) => Ok(None),
            (_, Look::Inspected(inspection)) => self.inspect(&inspection, goes_on),
            (Stage::Small, Look::Lit) => self.draw_small(goes_on).map(Some),
            (Stage::Full, Look::Lit) => self.draw_full(goes_on),
        };
        match drawn {
            Err(Error::Dense { .. }) => self.remake().map(|()| None),
            drawn => drawn,
        }
    }

    fn inspect(&mut self, inspection: &Inspection, goes_on: &dyn Fn() -> bool) -> Result<Option<Frame>, Error> {
        let size = if self.wanted.moving { self.inspected_pace.small(self.wanted.size) } else { self.wanted.size };
        let view = self.view()?;
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        subject.model.set_parameters(&subject.gpu, &self.wanted.parameters(&subject.scene))?;
        let begun = Instant::now();
        let Some((rgba, legend)) = self.inspecting()?.draw(view, size, inspection, goes_on)? else { return Ok(None) };
        let took = begun.elapsed();
        self.inspected_pace.note(size, took);
        let over = self.over(view, size, goes_on)?;
        self.stage = if size == self.wanted.size || self.wanted.moving { Stage::Done } else { Stage::Full };
        let picture = Picture { size, rgba, other: None, legend: Some(legend), over, view, samples: 1, took };
        self.frame(picture, took).map(Some)
    }

    /// Compiles the subject once more for what the live numbers are now: its model can't follow them.
    fn remake(&mut self) -> Result<(), Error> {
        let Some(subject) = &mut self.subject else { return Ok(()) };
        let parameters = self.wanted.parameters(&subject.scene);
        subject.model = Model::new(&subject.gpu, &subject.scene.picture(), &parameters)?;
        (self.small, self.full, self.inspecting, self.framing) = (None, None, None, None);
        self.stage = Stage::Small;
        Ok(())
    }

    fn inspecting(&mut self) -> Result<&mut Inspecting, Error> {
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        match &mut self.inspecting {
            Some(inspecting) => Ok(inspecting),
            empty => Ok(empty.insert(Inspecting::new(subject)?)),
        }
    }

    /// What lies over the picture.
    fn over(&mut self, view: View, size: [u32; 2], goes_on: &dyn Fn() -> bool) -> Result<Over, Error> {
        Ok(Over { mask: self.mask(view, size, goes_on)?, highlight: self.highlight(view, size, goes_on)? })
    }

    /// Which pixels show what is to be outlined.
    fn mask(
        &mut self,
        view: View,
        size: [u32; 2],
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<(Outlined, Mask)>, Error> {
        let (Some(subject), Some(outlined)) = (&self.subject, self.wanted.outlined.clone()) else { return Ok(None) };
        let parameters = self.wanted.parameters(&subject.scene);
        let mask = self.inspecting()?.mask(view, size, &outlined, &parameters, goes_on)?;
        Ok(mask.map(|mask| (outlined, mask)))
    }

    /// What is to be highlighted.
    fn highlight(&mut self, view: View, size: [u32; 2], goes_on: &dyn Fn() -> bool) -> Result<Option<Vec<u8>>, Error> {
        let (Some(subject), Some(solids)) = (self.subject.clone(), self.wanted.highlighted.clone()) else {
            return Ok(None);
        };
        let parameters = self.wanted.parameters(&subject.scene);
        self.inspecting()?.highlight(&subject, view, size, &solids, &parameters, goes_on)
    }

    fn draw_small(&mut self, goes_on: &dyn Fn() -> bool) -> Result<Frame, Error> {
        let size = self.pace.small(self.wanted.size);
        let view = self.view()?;
        let at_hand = self.small.take();
        let mut canvas = self.canvas(at_hand, size, view)?;
        canvas.prepare(&self.wanted, view)?;
        let begun = Instant::now();
        canvas.sample()?;
        let took = begun.elapsed();
        self.pace.note(size, took);
        // What was just written is to be seen first: its outline can't be known yet, and any other is out of date.
        let over = if self.is_first() { Over::default() } else { self.over(view, size, goes_on)? };
        let frame = self.frame(canvas.picture(over)?, took)?;
        self.small = Some(canvas);
        self.stage = if self.wanted.moving { Stage::Done } else { Stage::Full };
        Ok(frame)
    }

    fn draw_full(&mut self, goes_on: &dyn Fn() -> bool) -> Result<Option<Frame>, Error> {
        let view = self.view()?;
        let at_hand = self.full.take();
        let mut canvas = self.canvas(at_hand, self.wanted.size, view)?;
        canvas.prepare(&self.wanted, view)?;
        let begun = Instant::now();
        let is_complete = canvas.samples() < self.wanted.samples && canvas.step()?;
        let is_done = canvas.samples() >= self.wanted.samples;
        // A new outline doesn't wait for the sample.
        let is_outlined = canvas.samples() > 0 && std::mem::take(&mut self.outline_is_due);
        let is_due = canvas.samples() <= 1 || self.last_shown.is_none_or(|shown| shown.elapsed() >= SHOWN_EVERY);
        let shown = is_done || is_complete && is_due || is_outlined || canvas.samples() > 0 && self.is_first();
        let frame = if shown {
            let over = self.over(view, self.wanted.size, goes_on)?;
            Some(self.frame(canvas.picture(over)?, begun.elapsed())?)
        } else {
            None
        };
        if is_done {
            self.stage = Stage::Done;
        }
        self.full = Some(canvas);
        Ok(frame)
    }

    /// Whether there was no frame of the subject yet.
    fn is_first(&self) -> bool {
        self.subject.as_ref().is_some_and(|subject| subject.timings.asked.is_some())
    }

    /// A canvas of that size: the one at hand, if it is.
    fn canvas(&self, at_hand: Option<Canvas>, size: [u32; 2], view: View) -> Result<Canvas, Error> {
        let view = self.first_view.unwrap_or(view);
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        match at_hand.filter(|canvas| canvas.size() == size && canvas.compares() == self.wanted.other.is_some()) {
            Some(canvas) => Ok(canvas),
            None => Canvas::new(subject, size, view, &self.wanted),
        }
    }

    /// From where the subject is seen.
    fn view(&mut self) -> Result<View, Error> {
        let Some(subject) = &self.subject else { return Err(Error::NoDriver) };
        let eye = self.wanted.eye;
        let view = match eye {
            Eye::At(view) => view,
            Eye::Scene | Eye::Framed(..) => {
                let parameters = self.wanted.parameters(&subject.scene);
                let known = self.framing.take().filter(|(of, values, _)| *of == eye && *values == parameters);
                let (_, _, view) = match known {
                    Some(known) => self.framing.insert(known),
                    None => {
                        let view = framed(subject, &eye, &parameters, self.wanted.size)?;
                        self.framing.insert((eye, parameters, view))
                    }
                };
                *view
            }
        };
        self.first_view.get_or_insert(view);
        Ok(view)
    }

    fn frame(&mut self, picture: Picture, first_sample: Duration) -> Result<Frame, Error> {
        let Some(subject) = &mut self.subject else { return Err(Error::NoDriver) };
        let Picture { size, rgba, other, legend, over: Over { mask, highlight }, view, samples, took } = picture;
        let timings = &mut subject.timings;
        timings.sample = took;
        if let Some(asked) = timings.asked.take() {
            (timings.first_sample, timings.to_frame) = (first_sample, asked.elapsed());
        }
        self.last_shown = Some(Instant::now());
        let (revision, timings, wanted) = (subject.revision, *timings, self.wanted.clone());
        let scene = subject.scene.clone();
        Ok(Frame { revision, scene, size, rgba, other, legend, mask, highlight, wanted, view, samples, timings })
    }
}

/// The view that shows all of a subject.
fn framed(subject: &Subject, eye: &Eye, parameters: &[f64], size: [u32; 2]) -> Result<View, Error> {
    subject.model.set_parameters(&subject.gpu, parameters)?;
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    View::framing_model(&subject.gpu, &subject.model, &eye.camera(&subject.scene.camera), aspect)
}

/// What a frame shows.
struct Picture {
    size: [u32; 2],
    rgba: Vec<u8>,
    other: Option<Vec<u8>>,
    legend: Option<Legend>,
    over: Over,
    view: View,
    samples: u32,
    took: Duration,
}

/// What lies over a picture: the pixels that show what is outlined, and what is highlighted.
#[derive(Default)]
struct Over {
    mask: Option<(Outlined, Mask)>,
    highlight: Option<Vec<u8>>,
}
