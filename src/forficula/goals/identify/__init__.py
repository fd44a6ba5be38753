from forficula.goals.identify.observations import Observations
from forficula.goals.identify.observations_file import load_observations, named_observations, observations_of

__all__ = ["Observations", "load_observations", "named_observations", "observations_of"]
