from forficula.material.tendon_law import ElasticLaw

__all__ = ["ElasticLaw"]
