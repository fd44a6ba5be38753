import lazy_loader

# who works for it need not wait for its server
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
