"""One sub-command of the command line, one library call.

What each command needs is imported in it: help and errors come at once, without MuJoCo and matplotlib.
"""
