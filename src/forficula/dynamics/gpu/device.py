"""The device on which MuJoCo Warp simulates, and the structures that it can simulate."""

from __future__ import annotations

import ctypes
import hashlib
import sys
from functools import cache
from importlib.util import find_spec
from typing import Any

import mujoco
import numpy as np

from forficula.dynamics.engine.model import Model
from forficula.errors import InputError
from forficula.optional_module import optional_module

# the name of each device in Warp, by the value of protocol.device
_NAMES = {"gpu": "cuda:0", "warp-cpu": "cpu"}
_KEY = "protocol.device"
# options of the engine that a model on the device has once for all structures
_SHARED_OPTIONS = (
    "integrator",
    "solver",
    "cone",
    "jacobian",
    "iterations",
    "ls_iterations",
    "disableflags",
    "enableflags",
)


def warp_engine() -> Any:
    """Return the package mujoco_warp.

    Raises:
        InputError: it is not installed.
    """
    needs = f'{_KEY}: "gpu" and "warp-cpu" need MuJoCo Warp'
    warp = optional_module("warp", needs, "forficula[gpu]", '"cpu" needs no further package')
    # no messages about compiled kernels and missing drivers
    warp.config.log_level = warp.LOG_ERROR
    return optional_module("mujoco_warp", needs, "forficula[gpu]", '"cpu" needs no further package')


def check_available(device: str) -> None:
    """Refuse a device that this computer does not have.

    Args:
        device: value of `protocol.device`.

    Raises:
        InputError: MuJoCo Warp is not installed, or there is no such device.
    """
    if find_spec("mujoco_warp") is None:
        warp_engine()  # says how to install it
    if device == "gpu" and not (_has_driver() and _has_processor()):
        raise InputError(
            f'{_KEY}: need "cpu" on this computer, which has no graphics processor for CUDA or no driver for it,'
            ' got "gpu"'
        )


def _has_driver() -> bool:
    """Return whether there is a driver for CUDA; without one, Warp prints a warning of its own."""
    try:
        ctypes.CDLL("nvcuda.dll" if sys.platform == "win32" else "libcuda.so.1")
    except OSError:
        return False
    return True


def _has_processor() -> bool:
    """Return whether Warp finds a graphics processor."""
    warp_engine()
    import warp

    return bool(warp.get_cuda_device_count())


def device_name(device: str) -> str:
    """Return Warp's name of a device, a value of `protocol.device`.

    Raises:
        InputError: as for `check_available`.
    """
    check_available(device)
    return _NAMES[device]


def check_device(model: Model) -> None:
    """Refuse a structure that its device cannot simulate.

    Raises:
        InputError: the structure has parts that only the processor simulates; the message gives the reason.
    """
    device, reason = model.design.protocol.device, _why_not(model)
    if device is not None and reason:
        raise InputError(f'{model.design.name}: {_KEY}: need "cpu", because {reason}, got "{device}"')


def _why_not(model: Model) -> str:
    """Return why a structure cannot be simulated on a device; empty if it can."""
    if model.creases is not None and (model.creases.joints >= 0).any():
        return "creases that remember how they were turned are computed on the processor between the steps"
    if any(hinge.quadratic or hinge.cubic for hinge in model.structure.hinges):
        return "nonlinear springs of joints were not compared with MuJoCo Warp"
    if model.creases is not None:
        return (
            "creases of sheets and nets change numbers of the engine's flex every few steps, and on a device these"
            " numbers are the same for all structures"
        )
    if model.structure.has_contacts:
        return (
            "the number of contacts differs between structures and steps, while memory on a device is reserved before"
        )
    if model.drag is not None:
        return "the drag of air or water is computed on the processor between the steps"
    if (model.hinge_creep >= 0).any():
        return "joints that yield were not compared with MuJoCo Warp"
    if model.explicit:
        return (
            "closed loops and supported points take steps of Runge and Kutta, at whose ends a device does not keep the"
            " forces"
        )
    if model.folds.joints.tolist() != list(range(len(model.folds.joints))):
        return "a device reads the angles of goals from the first positions, which are those of bodies that move freely"
    if any(stage.quasi_static for stage in model.design.protocol.stages):
        return "quasi-static stages are computed by statics on the processor"
    return ""


@cache
def _fields() -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the engine's fields that may differ between structures on a device, and those that may not."""
    from dataclasses import fields

    types = warp_engine().Model
    every = {field.name: getattr(field.type, "shape", None) for field in fields(types) if field.name != "opt"}
    differ = tuple(name for name, shape in every.items() if shape and shape[0] == "*")
    known = {name for name, shape in every.items() if shape and shape[0] != "*"}
    return differ, tuple(name for name in sorted(known) if hasattr(mujoco.MjModel, name))


def varying_fields() -> tuple[str, ...]:
    """Return the engine's fields that may differ between structures on a device."""
    return _fields()[0]


def batch_key(model: Model) -> str:
    """Return a key of what structures in one batch on a device must share; empty for structures on the processor.

    These are all numbers that cannot differ on a device. A number that may differ is also 0 in all structures or in
    none, because a device leaves out what is 0.
    """
    if model.design.protocol.device is None:
        return ""
    engine, digest = model.engine, hashlib.sha256(model.design.protocol.device.encode())
    differ, shared = _fields()
    for name in shared:
        digest.update(np.ascontiguousarray(getattr(engine, name)).tobytes())
    digest.update(bytes(bool(np.any(getattr(engine, name))) for name in differ))
    digest.update(repr([int(getattr(engine.opt, name)) for name in _SHARED_OPTIONS]).encode())
    digest.update(np.array([*engine.opt.gravity, engine.opt.density, engine.opt.viscosity]).tobytes())
    return digest.hexdigest()
