"""The functions of Python libraries that open a file."""

OPENS = frozenset(
    {
        *("open", "imread", "FileStorage", "VideoCapture", "CascadeClassifier", "readNet", "readNetFromONNX"),
        *("YOLO", "InferenceSession", "load_model", "loadtxt", "genfromtxt", "read_csv"),
    }
)
"""Functions whose first argument is a file, by their last names."""
LOADS = frozenset({"numpy.load", "torch.load", "joblib.load", "xml.etree.ElementTree.parse", "torch.jit.load"})
"""Those whose last names say nothing."""
