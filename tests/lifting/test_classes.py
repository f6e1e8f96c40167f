import numpy as np

from sketch2shape.lifting.classes import parallel_classes


def test_parallel_edges_are_one_class_whatever_their_sense():
    vectors = np.array([[10, 0.1], [0, 7], [-20, 0], [0.05, -9], [5, 5.0]])
    label, sign = parallel_classes(vectors, np.hypot(*vectors.T), 0.2)
    assert label[0] == label[2]
    assert label[1] == label[3]
    assert len(set(label.tolist())) == 3
    assert sign[0] == -sign[2]
    assert sign[1] == -sign[3]
