//! The signs of operators, and how tight they bind.

use crate::tree::{BinaryOperator, UnaryOperator};

impl UnaryOperator {
    /// How it is written.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Negate => "-",
            Self::Plus => "+",
            Self::Not => "!",
            Self::BitNot => "~",
        }
    }
}

impl BinaryOperator {
    /// How it is written.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Or => "||",
            Self::And => "&&",
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::BitOr => "|",
            Self::BitAnd => "&",
            Self::ShiftLeft => "<<",
            Self::ShiftRight => ">>",
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Modulo => "%",
            Self::Power => "^",
        }
    }

    /// How tight it binds, counted from 0. All but `^`, which binds tighter than signs do, associate to the left.
    pub(crate) fn tightness(self) -> u8 {
        match self {
            Self::Or => 0,
            Self::And => 1,
            Self::Equal | Self::NotEqual => 2,
            Self::Greater | Self::GreaterEqual | Self::Less | Self::LessEqual => 3,
            Self::BitOr => 4,
            Self::BitAnd => 5,
            Self::ShiftLeft | Self::ShiftRight => 6,
            Self::Add | Self::Subtract => 7,
            Self::Multiply | Self::Divide | Self::Modulo => 8,
            Self::Power => 10,
        }
    }
}

/// How tight signs in front bind.
pub(crate) const UNARY_TIGHTNESS: u8 = 9;
