"""The C library as scallop.py calls it: where it is found, its structures field by field, and its functions."""

import ctypes
import os
import re

HERE = os.path.dirname(os.path.realpath(__file__))


def _abi_version():
    """The number of the binary interface, from its one place."""
    with open(os.path.join(HERE, "../../model/version.h"), encoding="utf-8") as header:
        return int(re.search(r"^#define SCALLOP_ABI (\d+)$", header.read(), re.MULTILINE)[1])


# `make install` writes its own: the number itself, so that the two files can be copied, and the folder of the library from HERE
ABI_VERSION = _abi_version()
BESIDE = "../../build"
LIBRARIES = tuple(f"{name}.so.{ABI_VERSION}" for name in ("libscallop", "libscallop-core"))

DOMAIN = -1  # SCALLOP_EDOMAIN
AT_REST_START, MOVING_EXTENSION, MOVING_CONTRACTION, STEADY = range(4)  # enum scallop_setting
KINDS = {"extension": 0, "contraction": 1}  # enum scallop_phase_kind


def _structure(name, *fields):
    """A C structure of (type, "names of fields") pairs."""
    each = [(field, kind) for kind, names in fields for field in names.split()]
    return type(name, (ctypes.Structure,), {"_fields_": each})


_double, _int, _pointer, _text = ctypes.c_double, ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p

# model/model.h
Crawler = _structure("scallop_crawler", (_double, "m1 m2 F1 F2 L T alpha"), (_pointer, "gait"))
Complaint = _structure("scallop_complaint", (_text, "name"), (_double, "given"), (_text, "allowed"))
# model/families.h
MOST_NUMBERS = 16  # SCALLOP_GAIT_NUMBERS
Family = _structure("scallop_gait_family", (_text, "name numbers usual allowed sentence sample"), (_int, "each"),
                    (_pointer, "fixed make"))
# model/measured/measured.h
FITS = 5  # of enum scallop_fit
OTHERS = 17  # SCALLOP_MEASURED_OTHERS
MeasuredOptions = _structure("scallop_measured_options", (_int, "fit"), (_double, "sigma period"))
MeasuredGait = _structure("scallop_measured_gait", (_pointer, "gait"), (_double, "L T alpha"))
# numerics/numerics.h
MODES_KEPT = 24
Modes = _structure("scallop_modes", (_int, "count"), (ctypes.c_byte * 2 * MODES_KEPT, "kept"))
PARAMETERS = ("m1", "m2", "F1", "F2", "L", "T", "alpha")
STEADY_NUMBERS = ("froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier", "v_low", "v_high")
PHASE_NUMBERS = ("t1", "dT", "v_end", "dx1", "dx2", "dxC")
Crawlers = _structure("scallop_crawlers", (ctypes.c_long, "count"), (_pointer, " ".join(PARAMETERS)), (_pointer, "gait"))
SteadyStates = _structure("scallop_steady_states", (_pointer, " ".join(STEADY_NUMBERS)), (_pointer, "regime modes status"))
Phases = _structure("scallop_phases", (_pointer, " ".join(PHASE_NUMBERS)), (_pointer, "regime modes status"))
SPAN = ("t_begin", "t_end", "duration", "v1_begin", "v1_end", "v2_begin", "v2_end", "dx1", "dx2")  # struct scallop_span
Mode = _structure("scallop_mode", (ctypes.c_byte, "s1 s2"))
Span = _structure("scallop_span", (_double, " ".join(SPAN)), (Mode, "mode"))
Visitor = ctypes.CFUNCTYPE(None, _pointer, _pointer)
SAMPLE = ("t", "x1", "x2", "xC", "v1", "v2", "l")  # struct scallop_sample, doubles
Sampler = ctypes.CFUNCTYPE(ctypes.c_bool, _pointer, _pointer)
# asymptotics/asymptotics.h
Formula = _structure("scallop_formula", (_text, "name equation"), (_int, "setting quantity remainder"),
                     (_text, "text"), (_pointer, "parts when"), (_text, "corrected"), (_int, "turns"))
Part = _structure("scallop_part", (_text, "name text"))
SYMBOLS, QUANTITIES, MESSAGE = 19, 16, 320  # SCALLOP_SYMBOLS, SCALLOP_QUANTITIES, SCALLOP_FORMULA_MESSAGE
# model/exact/ball.h, and numbers of FLINT
Fmpq, Arb = ctypes.c_long * 2, ctypes.c_long * 6
RationalCrawler = _structure("scallop_rational_crawler", (Fmpq, " ".join(PARAMETERS)), (_pointer, "gait"))

# asymptotics/observed/order.h
OrderPoint = _structure("scallop_order_point", (_double, "h err noise"), (ctypes.c_long, "row"), (_double, "pairwise"), (_int, "use"))
OrderWanted = _structure("scallop_order_wanted", (_double, "order tolerance"), (ctypes.c_bool, "at_least values"))
OrderResult = _structure("scallop_order_result", (_int, "verdict"), (_double, "order low high"), (_int, "interval used"),
                         (_double, "gci asymptotic_ratio"), (ctypes.c_char * 400, "reason"))  # SCALLOP_ORDER_REASON

PROTOTYPES = {  # function: result, arguments
    "scallop_status_text": (_text, _int),
    "scallop_regime_text": (_text, _int),
    "scallop_modes_text": (None, _pointer, _text),
    "scallop_gait_named": (_pointer, _text),
    "scallop_crawler_check": (_int, ctypes.POINTER(Crawler), ctypes.POINTER(Complaint)),
    "scallop_gait_family": (ctypes.POINTER(Family), _int),
    "scallop_make_gait": (_int, _pointer, ctypes.POINTER(Family), _text, ctypes.POINTER(_double), _int, ctypes.POINTER(_text)),
    "scallop_measured_new": (_pointer, _pointer, _pointer, _int, ctypes.POINTER(MeasuredOptions), _text, ctypes.POINTER(_text)),
    "scallop_measured_free": (None, _pointer),
    "scallop_measured_gait": (MeasuredGait, _pointer, _int),
    "scallop_measured_length": (_double, _pointer, _double),
    "scallop_measured_samples": (_int, _pointer, _pointer, _pointer),
    "scallop_measured_text": (None, _pointer, _text, ctypes.c_size_t),
    "scallop_measured_error": (_double, _double, ctypes.POINTER(_double)),
    "scallop_steady_batch": (ctypes.c_long, ctypes.POINTER(Crawlers), ctypes.POINTER(SteadyStates), _int),
    "scallop_phase_batch": (ctypes.c_long, ctypes.POINTER(Crawlers), _int, _pointer, ctypes.POINTER(Phases), _int),
    "scallop_phase_intervals": (_int, ctypes.POINTER(Crawler), _int, _double, Visitor, _pointer),
    "scallop_interval_span": (Span, _pointer, ctypes.POINTER(Crawler), _int),
    "scallop_trajectory": (_int, ctypes.POINTER(Crawler), _double, ctypes.c_long, ctypes.c_long, Sampler, _pointer),
    "scallop_order": (None, ctypes.POINTER(OrderPoint), ctypes.POINTER(_int), ctypes.POINTER(OrderWanted),
                      ctypes.POINTER(OrderResult)),
    "scallop_order_use_text": (_text, _int),
    "scallop_order_verdict_text": (_text, _int),
    "scallop_order_interval_text": (_text, _int),
    "scallop_formula_read": (_pointer, ctypes.POINTER(Formula), _text),
    "scallop_formula_free": (None, _pointer),
    "scallop_formula_double": (_double, _pointer, ctypes.POINTER(Crawler), _int, _double, _double, _double, _double),
}
PROVEN = {  # those of libscallop built with FLINT: asymptotics/derived/expansion.h, model/exact/ball.h, FLINT
    "scallop_rational_init": (None, ctypes.POINTER(RationalCrawler)),
    "scallop_rational_clear": (None, ctypes.POINTER(RationalCrawler)),
    "scallop_series_of_phase": (_int, ctypes.POINTER(_pointer), ctypes.POINTER(RationalCrawler), _int, Fmpq, ctypes.c_long,
                                ctypes.c_long, ctypes.POINTER(_text)),
    "scallop_series_of_steady": (_int, ctypes.POINTER(_pointer), ctypes.POINTER(RationalCrawler), ctypes.c_long, ctypes.c_long,
                                 ctypes.POINTER(_text)),
    "scallop_series_free": (None, _pointer),
    "scallop_series_rational": (ctypes.c_bool, Fmpq, _pointer, _int, ctypes.c_long),
    "scallop_series_ball": (ctypes.c_bool, Arb, _pointer, _int, ctypes.c_long),
    "scallop_series_first": (ctypes.c_long, _pointer, _int),
    "scallop_series_modes": (_text, _pointer),
    "scallop_formula_ball": (_int, Arb, _pointer, ctypes.POINTER(RationalCrawler), _int, Fmpq, _pointer, ctypes.c_long),
    "fmpq_init": (None, Fmpq),
    "fmpq_clear": (None, Fmpq),
    "fmpq_set_str": (_int, Fmpq, _text, _int),
    "fmpq_get_str": (_pointer, _pointer, _int, Fmpq),
    "arb_init": (None, Arb),
    "arb_clear": (None, Arb),
    "arb_get_str": (_pointer, Arb, ctypes.c_long, ctypes.c_ulong),
    "flint_free": (None, _pointer),
}


_loaded = None


def load(path=None):
    """Loads the library in file `path`, or the one found as said above, and uses it from now on. Its name must end in
    .so.N or .so.N.MINOR..., N being ABI_VERSION, or be a link to such a file. OSError: it is not there, cannot be loaded, or is of another
    version. Returns its name."""
    global _loaded
    path = path or os.environ.get("SCALLOP_LIBRARY")
    _loaded = _bind(_open(_versioned(os.fspath(path))) if path else _found(), PROTOTYPES)
    return _loaded._name


def library():
    if _loaded is None:
        load()
    return _loaded


def _versioned(path):
    name = os.path.basename(os.path.realpath(path))
    version = re.search(r"\.so\.(\d+)(\.\d+)*(-dev)?$", name)
    if not version:
        raise OSError(f"{path}: the name does not say the version of the binary interface: .so.{ABI_VERSION} is wanted")
    if int(version[1]) != ABI_VERSION:
        raise OSError(f"{path}: version {version[1]} of the binary interface: version {ABI_VERSION} is wanted")
    return os.path.abspath(path)


def _open(path):
    try:
        return ctypes.CDLL(path)
    except OSError as error:
        raise OSError(f"cannot load the library of scallop: {error}") from None


def _found():
    beside = os.path.normpath(os.path.join(HERE, BESIDE))
    for name in LIBRARIES:
        if os.path.exists(os.path.join(beside, name)):
            return _open(os.path.join(beside, name))
    for name in LIBRARIES:
        try:
            return ctypes.CDLL(name)
        except OSError:
            pass
    raise OSError(f"neither {' nor '.join(LIBRARIES)} is in {beside} or known to the system's loader: build or install it, "
                  "or name it in SCALLOP_LIBRARY or scallop.load(path)")


def _bind(loaded, prototypes):
    for name, (result, *arguments) in prototypes.items():
        try:
            function = getattr(loaded, name)
        except AttributeError:
            raise OSError(f"{loaded._name} has no {name}: it is older than scallop.py, or another library") from None
        function.restype, function.argtypes = result, arguments
    return loaded


def proven(loaded):
    """The same library with its fractions and balls. OSError: it has none."""
    if not hasattr(loaded, "scallop_series_of_steady"):
        raise OSError(f"{loaded._name} has no derived series and no proven digits: {LIBRARIES[0]}, built with FLINT, has")
    return _bind(loaded, PROVEN)


def words(loaded, name, count):
    """A table of that many texts"""
    return [text.decode() for text in (_text * count).in_dll(loaded, name)]
