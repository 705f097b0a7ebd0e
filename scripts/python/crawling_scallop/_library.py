"""The C library as this package calls it: where it is found, its structures field by field, and its functions."""

from __future__ import annotations

import ctypes
import json
import os
import re
from typing import Any, Optional, Type

from ._errors import MissingError

HERE = os.path.dirname(os.path.realpath(__file__))


def _place() -> dict[str, Any]:
    """What was installed with this package, and where. `make install` and the wheel write installed.json; the source tree
    has none."""
    try:
        with open(os.path.join(HERE, "installed.json"), encoding="utf-8") as file:
            return dict(json.load(file))
    except FileNotFoundError:
        with open(os.path.join(HERE, "../../../model/version.h"), encoding="utf-8") as header:
            text = header.read()
    found = [re.search(pattern, text, re.MULTILINE)
             for pattern in (r'^#define SCALLOP_VERSION "(.*)"$', r"^#define SCALLOP_ABI (\d+)$")]
    version, abi = (each[1] if each else "" for each in found)
    return {"version": version, "abi": int(abi), "libraries": "../../../build", "command": "../../../build/scallop",
            "data": "../../../data"}


def beside(name: str) -> str:
    """A folder or file that was installed with this package; of several places, the one where it is, or the first"""
    places = PLACE[name] if isinstance(PLACE[name], list) else [PLACE[name]]
    paths = [os.path.normpath(os.path.join(HERE, place)) for place in places]
    return next((path for path in paths if os.path.exists(path)), paths[0])


PLACE = _place()
VERSION, ABI_VERSION = PLACE["version"], PLACE["abi"]
LIBRARIES = tuple(f"{name}.so.{ABI_VERSION}" for name in ("libscallop", "libscallop-core"))

OUTSIDE, UNDECIDED = -1, -4  # SCALLOP_EDOMAIN, SCALLOP_EUNDECIDED
AT_REST_START, MOVING_EXTENSION, MOVING_CONTRACTION, STEADY = range(4)  # enum scallop_setting
KINDS = {"extension": 0, "contraction": 1}  # enum scallop_phase_kind


def _structure(name: str, *fields: tuple[Any, str]) -> Type[ctypes.Structure]:
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
Work = _structure("scallop_work", (ctypes.c_long, "periods events gait_evaluations root_iterations"))
PhaseResult = _structure("scallop_phase_result", (_double, " ".join(PHASE_NUMBERS)), (_int, "regime"), (Modes, "modes"), (Work, "work"))
PeriodResult = _structure("scallop_period_result", (_double, "v_start v_mid v_end displacement multiplier balance"), (_int, "regime"),
                          (Modes * 2, "modes"))
SteadyResult = _structure("scallop_steady_result", (_double, "froude mean_velocity"), (PeriodResult, "period"),
                          (_double, "v_low v_high"), (Work, "work"))
# numerics/wide/wide.h
STEADY_ERRORS = STEADY_NUMBERS[:6]
SteadyError = _structure("scallop_steady_error", (_double, " ".join(STEADY_ERRORS)))
PhaseError = _structure("scallop_phase_error", (_double, " ".join(PHASE_NUMBERS)))
# asymptotics/asymptotics.h
Formula = _structure("scallop_formula", (_text, "name equation"), (_int, "setting quantity remainder"),
                     (_text, "text"), (_pointer, "parts when"), (_text, "corrected"), (_int, "turns"))
Part = _structure("scallop_part", (_text, "name text"))
SYMBOLS, QUANTITIES, MESSAGE = 19, 16, 320  # SCALLOP_SYMBOLS, SCALLOP_QUANTITIES, SCALLOP_FORMULA_MESSAGE
# model/exact/ball.h, and numbers of FLINT
Fmpq, Arb = ctypes.c_long * 2, ctypes.c_long * 6
RationalCrawler = _structure("scallop_rational_crawler", (Fmpq, " ".join(PARAMETERS)), (_pointer, "gait"))
# numerics/certified/certified.h
MOST_DIGITS = 100000  # SCALLOP_MOST_DIGITS
CertifiedPhase = _structure("scallop_certified_phase", (ctypes.c_bool, "switches"),
                            (Arb, " ".join(PHASE_NUMBERS) + " at_first at_last multiplier"), (_int, "regime"), (Modes, "modes"))
CertifiedSteady = _structure("scallop_certified_steady", (Arb, " ".join(STEADY_ERRORS) + " friction_work"), (_int, "regime"),
                             (Modes * 2, "modes"))

# asymptotics/observed/order.h
OrderPoint = _structure("scallop_order_point", (_double, "h err noise"), (ctypes.c_long, "row"), (_double, "pairwise"), (_int, "use"))
OrderWanted = _structure("scallop_order_wanted", (_double, "order tolerance"), (ctypes.c_bool, "at_least values"))
OrderResult = _structure("scallop_order_result", (_int, "verdict"), (_double, "order low high"), (_int, "interval used"),
                         (_double, "gci asymptotic_ratio"), (ctypes.c_char * 400, "reason"))  # SCALLOP_ORDER_REASON

PROTOTYPES: dict[str, tuple[Any, ...]] = {  # function: result, arguments
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
    "scallop_steady": (_int, ctypes.POINTER(Crawler), ctypes.POINTER(SteadyResult)),
    "scallop_phase": (_int, ctypes.POINTER(Crawler), _int, _double, ctypes.POINTER(PhaseResult)),
    "scallop_steady_error": (_int, ctypes.POINTER(Crawler), ctypes.POINTER(SteadyResult), ctypes.POINTER(SteadyError)),
    "scallop_phase_error": (_int, ctypes.POINTER(Crawler), _int, _double, ctypes.POINTER(PhaseResult),
                            ctypes.POINTER(PhaseError)),
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
PROVEN: dict[str, tuple[Any, ...]] = {  # those of libscallop built with FLINT: asymptotics/derived/expansion.h, model/exact/ball.h, FLINT
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
    "scallop_certified_phase_init": (None, ctypes.POINTER(CertifiedPhase)),
    "scallop_certified_phase_clear": (None, ctypes.POINTER(CertifiedPhase)),
    "scallop_certified_phase": (_int, ctypes.POINTER(RationalCrawler), _int, Fmpq, ctypes.c_long,
                                ctypes.POINTER(CertifiedPhase), ctypes.POINTER(_text)),
    "scallop_certified_steady_init": (None, ctypes.POINTER(CertifiedSteady)),
    "scallop_certified_steady_clear": (None, ctypes.POINTER(CertifiedSteady)),
    "scallop_certified_steady": (_int, ctypes.POINTER(RationalCrawler), ctypes.c_long, ctypes.POINTER(CertifiedSteady),
                                 ctypes.POINTER(_text)),
    "fmpq_init": (None, Fmpq),
    "fmpq_clear": (None, Fmpq),
    "fmpq_set_str": (_int, Fmpq, _text, _int),
    "fmpq_get_str": (_pointer, _pointer, _int, Fmpq),
    "arb_init": (None, Arb),
    "arb_clear": (None, Arb),
    "arb_get_str": (_pointer, Arb, ctypes.c_long, ctypes.c_ulong),
    "flint_free": (None, _pointer),
}


_loaded: Optional[ctypes.CDLL] = None


def load(path: str | os.PathLike[str] | None = None) -> str:
    """Load the library for all later calls.

    Parameters
    ----------
    path : path, optional
        The file. Its name must end in ``.so.N`` or ``.so.N.MINOR...``, N being the version of the binary interface of
        this package, or be a link to such a file. Without it the first of these is taken: the environment variable
        ``SCALLOP_LIBRARY``, the library that was installed with this package (in the source tree: built in ``build/``),
        and what the loader of the system finds.

    Returns
    -------
    str
        The name of the library.

    Raises
    ------
    MissingError
        It is not there, cannot be loaded, or is of another version.

    Examples
    --------
    >>> import crawling_scallop
    >>> crawling_scallop.load().rpartition("/")[2].startswith("libscallop")
    True
    """
    global _loaded
    path = path or os.environ.get("SCALLOP_LIBRARY")
    _loaded = _bind(_open(_versioned(os.fspath(path))) if path else _found(), PROTOTYPES)
    return str(_loaded._name)


def library() -> ctypes.CDLL:
    if _loaded is None:
        load()
    assert _loaded is not None
    return _loaded


def _versioned(path: str) -> str:
    name = os.path.basename(os.path.realpath(path))
    version = re.search(r"\.so\.(\d+)(\.\d+)*(-dev)?$", name)
    if not version:
        raise MissingError(f"{path}: the name does not say the version of the binary interface: .so.{ABI_VERSION} is wanted")
    if int(version[1]) != ABI_VERSION:
        raise MissingError(f"{path}: version {version[1]} of the binary interface: version {ABI_VERSION} is wanted")
    return os.path.abspath(path)


def _open(path: str) -> ctypes.CDLL:
    try:
        return ctypes.CDLL(path)
    except OSError as error:
        raise MissingError(f"cannot load the library of crawling_scallop: {error}") from None


def _found() -> ctypes.CDLL:
    folder = beside("libraries")
    for name in LIBRARIES:
        if os.path.exists(os.path.join(folder, name)):
            return _open(os.path.join(folder, name))
    for name in LIBRARIES:
        try:
            return ctypes.CDLL(name)
        except OSError:
            pass
    raise MissingError(f"neither {' nor '.join(LIBRARIES)} is in {folder} or known to the system's loader: build or install "
                       "it, or name it in SCALLOP_LIBRARY or crawling_scallop.load(path)")


def _bind(loaded: ctypes.CDLL, prototypes: dict[str, tuple[Any, ...]]) -> ctypes.CDLL:
    for name, (result, *arguments) in prototypes.items():
        try:
            function = getattr(loaded, name)
        except AttributeError:
            raise MissingError(f"{loaded._name} has no {name}: it is older than this package, or another library") from None
        function.restype, function.argtypes = result, arguments
    return loaded


def proven(loaded: ctypes.CDLL) -> ctypes.CDLL:
    """The same library with its fractions and balls. MissingError: it has none."""
    if not hasattr(loaded, "scallop_series_of_steady"):
        raise MissingError(f"{loaded._name} has no derived series and no proven digits: {LIBRARIES[0]}, built with FLINT, has")
    return _bind(loaded, PROVEN)


def words(loaded: ctypes.CDLL, name: str, count: int) -> list[str]:
    """A table of that many texts"""
    return [(text or b"").decode() for text in (_text * count).in_dll(loaded, name)]


def status_text(status: int) -> str:
    return bytes(library().scallop_status_text(status)).decode()
