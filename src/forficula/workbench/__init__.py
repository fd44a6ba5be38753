import lazy_loader

# worker processes import parts of this package without the server
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
