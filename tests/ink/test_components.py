"""Connected pieces and where they lie."""

from __future__ import annotations

import numpy as np
import pytest

from sketch2shape.ink.components import Pieces, connected_pieces


def label_of(pieces: Pieces) -> np.ndarray:
    """(h, w) the piece that each pixel belongs to, or 0."""
    label = np.zeros(pieces.mask.size, int)
    label[pieces.where] = pieces.piece
    return label.reshape(pieces.mask.shape)


def test_a_ring_and_the_speck_within_it_are_two_pieces() -> None:
    mask = np.zeros((60, 80), np.uint8)
    mask[4:42, 9:52] = 1
    mask[7:39, 12:49] = 0
    mask[20, 30] = 1
    pieces = connected_pieces(mask)
    label = label_of(pieces)
    ring, speck = label[5, 10], label[20, 30]
    assert sorted((ring, speck)) == [1, 2]
    assert pieces.low[ring].tolist() == [9, 4]
    assert pieces.high[ring].tolist() == [51, 41]
    assert pieces.low[speck].tolist() == pieces.high[speck].tolist() == [30, 20]
    assert pieces.extent[[0, ring, speck]].tolist() == pytest.approx([0, np.hypot(43, 38), np.sqrt(2)])
    assert pieces.outlines[ring - 1][:, 0].min(axis=0).tolist() == [9, 4]


def test_boxes_are_those_of_the_labels_whatever_is_drawn() -> None:
    mask = (np.random.default_rng(5).random((50, 70)) < 0.3).astype(np.uint8)
    pieces = connected_pieces(mask)
    label = label_of(pieces)
    assert np.array_equal(label > 0, mask > 0)
    for k in range(1, label.max() + 1):
        ys, xs = np.nonzero(label == k)
        assert np.array_equal(pieces.only(np.arange(len(pieces.low)) == k), label == k)
        assert [*pieces.low[k], *pieces.high[k]] == [xs.min(), ys.min(), xs.max(), ys.max()]


def test_nothing_drawn() -> None:
    pieces = connected_pieces(np.zeros((9, 9), np.uint8))
    assert len(pieces.low) == 1
    assert pieces.extent.tolist() == [0]
    assert pieces.outlines == ()
