# SPDX-License-Identifier: MIT
"""The shared library by ctypes: load and check it, errors, blocks of memory, callbacks.

Structs and functions (declarations.py) have the names of C, and the headers are their reference. Nothing here depends on the version
of Python. ctypes lets other threads run while a call is in the library.
"""
from __future__ import annotations

import concurrent.futures
import ctypes
import os
import signal
import sys
import threading
from ctypes import c_char_p, c_size_t
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, List, Optional, cast

import numpy as np

from . import declarations
from .declarations import *  # noqa: F401,F403  what C declares, under its names
from .declarations import MAX_THREADS, STATUS, VERSION_MAJOR, VERSION_MINOR, WORKSPACE_ALIGNMENT, sinew_parallel_for, sinew_progress

if TYPE_CHECKING:
    Array = np.ndarray[Any, np.dtype[Any]]
else:
    Array = np.ndarray  # which Python 3.8 cannot subscript

_CANCELLED = STATUS["ERROR_CANCELLED"]
_VERSION = f"{VERSION_MAJOR}.{VERSION_MINOR}."  # structs of one minor version have the same layout


class Error(RuntimeError):
    """A failed call, with one line of text. `status` is the sinew_status, or 0 for other causes."""

    def __init__(self, message: str, status: int = 0) -> None:
        super().__init__(message)
        self.status = status


class Cancelled(Error):
    """The progress function stopped the call; nothing was changed."""


_library: Optional[ctypes.CDLL] = None


def data_folder() -> Path:
    """Folder of the package's library and models."""
    return Path(__file__).resolve().parent / "data"


def _library_path() -> Path:
    named = os.environ.get("SINEW_LIBRARY")
    if named:
        if not Path(named).is_file():
            raise Error(f"SINEW_LIBRARY={named}: no such file; expected the shared library of the engine")
        return Path(named)
    names = {"win32": ["libsinew_character.dll", "sinew_character.dll", "libsinew.dll", "sinew.dll"],
             "darwin": ["libsinew_character.dylib", "libsinew.dylib"]}.get(sys.platform, ["libsinew_character.so", "libsinew.so"])
    for name in names:
        if (data_folder() / name).is_file():
            return data_folder() / name
    raise Error(f"{data_folder() / names[0]}: the engine's library is missing; install the wheel that samples/python/build.sh "
                "makes, or name a library in SINEW_LIBRARY")


def library() -> ctypes.CDLL:
    """The shared library, loaded once. Raises Error if it is missing, for another machine or of another version."""
    global _library
    if _library is not None:
        return _library
    path = _library_path()
    try:
        loaded = ctypes.CDLL(str(path))
    except OSError as error:
        raise Error(f"{path}: cannot load the engine's library, {error}; it must be built for this machine") from None
    try:
        loaded.sinew_version.restype = c_char_p
        version = loaded.sinew_version().decode()
        if not version.startswith(_VERSION):
            raise Error(f"{path}: expected version {_VERSION}x of the engine, found {version}; install library and package of "
                        "one version")
        _declare(loaded, declarations.FUNCTIONS)
        _compare_sizes(loaded.sinew_struct_size, declarations.STRUCTS, path)
        if hasattr(loaded, "sinew_character_open"):
            _declare(loaded, declarations.CHARACTER_FUNCTIONS)
            _compare_sizes(loaded.sinew_character_struct_size, declarations.CHARACTER_STRUCTS, path)
    except AttributeError as error:
        raise Error(f"{path}: expected a library of sinew {_VERSION}x, {error}") from None
    _library = loaded
    return loaded


def character_library() -> ctypes.CDLL:
    """library() with the calls of sinew/character.h. Raises Error if it is only the engine."""
    loaded = library()
    if not hasattr(loaded, "sinew_character_open"):
        raise Error(f"{_library_path()}: is only the engine; files and the command's jobs need libsinew_character")
    return loaded


def _declare(loaded: ctypes.CDLL, functions: Any) -> None:
    for name, (result, arguments) in functions.items():
        function = getattr(loaded, name)
        function.restype, function.argtypes = result, arguments


def _compare_sizes(size_of: Callable[[bytes], int], structs: Any, path: Any) -> None:
    """Raises Error if a struct of the library differs from its declaration here. One with a struct_size may have grown."""
    for one in structs:
        here, there = ctypes.sizeof(one), size_of(one.__name__.encode())
        if there != here and not (one._fields_[0][0] == "struct_size" and there > here):
            raise Error(f"{path}: {one.__name__} has {there} bytes, this package was made for {here}; install library and package of one build")


def check(status: int, what: str) -> None:
    """Raises Error with `what` and the status' text, or Cancelled; nothing for SINEW_OK."""
    if status != 0:
        text = library().sinew_status_text(status).decode()
        raise (Cancelled if status == _CANCELLED else Error)(f"{what}: {text}", status)


def init(struct: type) -> Any:
    """A struct that begins with struct_size, as its ..._init() of C makes it: all else is 0."""
    return struct(struct_size=ctypes.sizeof(struct))


def address(array: Optional[Array]) -> Optional[int]:
    """Address of an array's elements for a c_void_p; None stays null. The caller keeps the array alive."""
    return None if array is None else int(array.ctypes.data)


class Block:
    """Uninitialized bytes at an address divisible by 64."""

    def __init__(self, size_bytes: int) -> None:
        try:
            self._memory = np.empty(size_bytes + WORKSPACE_ALIGNMENT, np.uint8)
        except (MemoryError, ValueError):
            raise Error(f"no memory for a workspace of {size_bytes // 1000000} MB in one piece") from None
        self.size_bytes = size_bytes
        self.address = -(-self._memory.ctypes.data // WORKSPACE_ALIGNMENT) * WORKSPACE_ALIGNMENT


def block(size_query: str, what: str, *arguments: Any) -> Block:
    """A block of the size returned by size_query(*arguments, &size)."""
    size = c_size_t(0)
    check(getattr(library(), size_query)(*arguments, ctypes.byref(size)), what)
    return Block(size.value)


class Progress:
    """A Python function as sinew_progress, for the time of a `with` block. It returns True to stop the call. What it raises ends the
    call and is raised by finish(), and so does Ctrl-C.

    Python raises KeyboardInterrupt between two of its own instructions, which may be the first of a callback: ctypes would print and lose
    it there. In the main thread Ctrl-C is therefore noted while the library works, and given to the handler that was there afterwards.
    """

    def __init__(self, function: Optional[Callable[[float], Any]]) -> None:
        self._function = function
        self._raised: Optional[BaseException] = None
        self._interrupts: List[Any] = []
        self._before: Any = None
        self.callback = sinew_progress(self._step)

    def __enter__(self) -> "Progress":
        if threading.current_thread() is threading.main_thread():
            before = signal.getsignal(signal.SIGINT)
            if callable(before):
                self._before = before
                signal.signal(signal.SIGINT, lambda number, frame: self._interrupts.append((number, frame)))
        return self

    def __exit__(self, *_: Any) -> None:
        if self._before is None:
            return
        before, self._before = self._before, None
        signal.signal(signal.SIGINT, before)
        if self._interrupts:
            interrupts, self._interrupts = self._interrupts, []
            before(*interrupts[0])

    def _step(self, _user: Any, done_permille: int) -> int:
        if self._interrupts:
            return 1
        try:
            return 1 if self._function is not None and self._function(done_permille / 1000) else 0
        except BaseException as error:  # nothing may pass through the library
            self._raised = error
            return 1

    def finish(self, status: int, what: str, line: str = "") -> None:
        """check(), or an Error of that line, but Ctrl-C and what the function raised go first."""
        if self._interrupts:
            self.__exit__()
        if self._raised is not None:
            raise self._raised
        if line and status != _CANCELLED:
            raise Error(line, status)
        check(status, what)


class Threads:
    """Threads of a pool as sinew_parallel_for, for the time of a `with` block."""

    def __init__(self, count: int) -> None:
        if not 1 <= count <= MAX_THREADS:
            raise ValueError(f"threads: expected 1 to {MAX_THREADS}, found {count}")
        self.count = count
        self.callback: Any = cast(Any, sinew_parallel_for)()  # null
        self._pool: Optional[concurrent.futures.ThreadPoolExecutor] = None

    def __enter__(self) -> "Threads":
        if self.count > 1:
            self._pool = concurrent.futures.ThreadPoolExecutor(self.count - 1)
            self.callback = sinew_parallel_for(self._run)
        return self

    def __exit__(self, *_: Any) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def _run(self, _user: Any, count: int, body: Any, body_data: Any) -> None:
        assert self._pool is not None
        others = [self._pool.submit(body, body_data, i) for i in range(1, count)]
        body(body_data, 0)
        for other in others:
            other.result()
