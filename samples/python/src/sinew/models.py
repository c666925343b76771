# SPDX-License-Identifier: MIT
"""Models: files that are checked and packed once, and cached."""
from __future__ import annotations

import ctypes
import os
import threading
from pathlib import Path
from typing import Any, Dict, Literal, Optional, Tuple, Union

import numpy as np

from . import binding

Task = Literal["weights", "skeletons", "hands", "fronts"]
BUNDLED: Dict[Task, str] = {"weights": "sinew_default.sinew", "skeletons": "sinew_rig.sinew", "hands": "sinew_hands.sinew",
                           "fronts": "sinew_front.sinew"}


class Model:
    """A model file.

    source  path of the file, or its bytes
    task    "weights" for bind() and transfer(), "skeletons" for rig(), "hands" for its fingers, "fronts" for the front direction
    Raises binding.Error, with the file name, if it is missing or damaged.
    """

    def __init__(self, source: Union[str, "os.PathLike[str]", bytes], task: Task = "weights") -> None:
        if isinstance(source, bytes):
            content, self.name = source, f"model of {len(source)} bytes"
        else:
            self.name = os.fspath(source)
            try:
                content = Path(source).read_bytes()
            except OSError as error:
                raise binding.Error(f"{self.name}: cannot read the model, {error.strerror}") from None
        self._bytes = np.zeros(-(-max(len(content), 1) // 8), np.uint64)  # at an address divisible by 8
        self._bytes.view(np.uint8)[:len(content)] = np.frombuffer(content, np.uint8)
        self.struct = binding.sinew_model()
        library = binding.library()
        open_model = library.sinew_model_open if task == "weights" else library.sinew_rig_model_open
        binding.check(open_model(self._bytes.ctypes.data, len(content), self.pointer()), self.name)
        if task != "weights":
            return
        size = ctypes.c_size_t()
        binding.check(library.sinew_model_pack_workspace_size(self.pointer(), ctypes.byref(size)), self.name)
        self._packed = binding.Block(size.value)
        binding.check(library.sinew_model_pack(self.pointer(), self._packed.address, self._packed.size_bytes), self.name)

    def pointer(self) -> Any:
        return ctypes.byref(self.struct)


_kept: Dict[Tuple[str, Task], Model] = {}
_lock = threading.Lock()


def model_for(model: Optional[Union[str, "os.PathLike[str]", Model]], task: Task) -> Model:
    """Returns a Model unchanged, a cached Model of a file, or the bundled one for None."""
    if isinstance(model, Model):
        return model
    path = binding.data_folder() / BUNDLED[task] if model is None else Path(model)
    if model is None and not path.is_file() and os.environ.get("SINEW_MODELS"):
        path = Path(os.environ["SINEW_MODELS"]) / BUNDLED[task]
    key = (str(path), task)
    with _lock:
        if key not in _kept:
            _kept[key] = Model(path, task)
        return _kept[key]
