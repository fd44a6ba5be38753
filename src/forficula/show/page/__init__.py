import lazy_loader

# modules are loaded on first use: a page without a run does not import what reads runs
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
