import lazy_loader

# a page that shows no run need not wait for what reads one
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
