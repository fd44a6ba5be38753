import lazy_loader

# what draws or prints comes when it is asked for: a command that only prints need not wait for what draws
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
