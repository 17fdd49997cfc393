"""The mean SSIM of two pictures' luma (Wang et al. 2004, with its settings) and their mean difference of 255."""

import sys

import numpy as np
from PIL import Image


def luma(path):
    pixels = np.asarray(Image.open(path).convert("RGB")).astype(float) / 255
    return pixels @ np.array([0.2126, 0.7152, 0.0722])


def blurred(picture):
    kernel = np.exp(-((np.arange(11) - 5) ** 2) / (2 * 1.5**2))
    kernel /= kernel.sum()
    for axis in (0, 1):
        line = lambda values: np.convolve(np.pad(values, 5, mode="reflect"), kernel, "valid")
        picture = np.apply_along_axis(line, axis, picture)
    return picture


def ssim(a, b):
    mean_a, mean_b = blurred(a), blurred(b)
    variance_a, variance_b = blurred(a * a) - mean_a**2, blurred(b * b) - mean_b**2
    covariance = blurred(a * b) - mean_a * mean_b
    luminance = (2 * mean_a * mean_b + 1e-4) / (mean_a**2 + mean_b**2 + 1e-4)
    structure = (2 * covariance + 9e-4) / (variance_a + variance_b + 9e-4)
    return (luminance * structure).mean()


def compared(first, second):
    """What there is to say of two files with pictures."""
    a, b = luma(first), luma(second)
    if a.shape != b.shape:
        return f"the pictures have different sizes: {a.shape} and {b.shape}"
    return f"SSIM {ssim(a, b):.4f}, mean difference {np.abs(a - b).mean() * 255:.2f}"


if __name__ == "__main__":
    print(compared(sys.argv[1], sys.argv[2]))
