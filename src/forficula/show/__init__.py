import lazy_loader

# modules are loaded on first use: a command that only prints does not import what draws
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
