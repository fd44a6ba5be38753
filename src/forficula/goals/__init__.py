from forficula.goals.goal import Goal, Objective
from forficula.goals.goal_file import goal_of, load_goal, named_goals

__all__ = ["Goal", "Objective", "goal_of", "load_goal", "named_goals"]
