# SPDX-License-Identifier: MIT
"""Operators that read the scene, run the engine, and only then change the scene: at once for small meshes, in a thread with
progress and Esc for large ones."""
import os
import threading
import time

import bpy

from .sinew import Cancelled, Error


class Problem(Exception):
    """An error for the user, in one line with the remedy."""


class EngineOperator:
    """gather() reads the scene, compute() has numpy and the engine alone, apply() writes. Only apply() changes anything.

    Subclasses set `label`, and `vertex_count` in gather().
    """

    label = "sinew"
    vertex_count = 0
    threaded_from: bpy.props.IntProperty(
        name="Thread From", description="Process meshes with at least this many vertices in the background, with progress; Esc stops",
        default=200000, min=0, options={"HIDDEN", "SKIP_SAVE"})

    def gather(self, context):
        raise NotImplementedError

    def compute(self, gathered, progress):
        raise NotImplementedError

    def apply(self, context, gathered, result):
        raise NotImplementedError

    def execute(self, context):
        manager = context.window_manager
        manager.progress_begin(0, 100)
        try:
            gathered = self.gather(context)

            def progress(share):
                manager.progress_update(100 * share)

            result = self.compute(gathered, progress)
            return self._finish(context, gathered, result)
        except Exception as error:  # one line for the user; nothing was changed
            return self._refuse(error)
        finally:
            manager.progress_end()

    def invoke(self, context, _event):
        try:
            self._gathered = self.gather(context)
        except Exception as error:
            return self._refuse(error)
        if self.vertex_count < self.threaded_from:
            return self.execute(context)
        self._share, self._stop, self._result, self._error = 0.0, False, None, None

        def progress(share):
            self._share = share
            time.sleep(0)  # Blender's own thread goes on
            return self._stop

        def run():
            try:
                self._result = self.compute(self._gathered, progress)
            except BaseException as error:  # told by the thread that may tell
                self._error = error

        self._thread = threading.Thread(target=run, name="sinew", daemon=True)
        self._thread.start()
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.progress_begin(0, 100)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self._stop = True
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}  # nothing else may change what is worked on
        context.window_manager.progress_update(100 * self._share)
        stopping = ", stopping" if self._stop else ", Esc stops"
        context.workspace.status_text_set(f"{self.label}: {100 * self._share:.0f} %{stopping}")
        if self._thread.is_alive():
            return {"RUNNING_MODAL"}
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        try:
            if self._stop:  # also where the work was done before it saw that
                raise Cancelled("stopped")
            if self._error is not None:
                raise self._error
            return self._finish(context, self._gathered, self._result)
        except Exception as error:
            return self._refuse(error)

    def cancel(self, _context):
        """Blender closes while the thread works."""
        self._stop = True
        self._thread.join(10)

    def _finish(self, context, gathered, result):
        self.apply(context, gathered, result)
        return {"FINISHED"}

    def _refuse(self, error):
        if isinstance(error, Cancelled):
            self.report({"WARNING"}, f"{self.label}: stopped, nothing was changed")
        elif isinstance(error, (Problem, Error, ValueError)):
            self.report({"ERROR"}, f"{self.label}: {error}")
        else:
            import traceback
            traceback.print_exc()
            self.report({"ERROR"}, f"{self.label}: {type(error).__name__}: {error}; details are on the terminal")
        return {"CANCELLED"}


def thread_count(vertices):
    """How many threads the engine gets: what is there, up to 8; one where handing out the work takes as long as it saves."""
    return 1 if vertices < 20000 else max(1, min(8, os.cpu_count() or 1))
