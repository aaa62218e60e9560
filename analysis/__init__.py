"""Tables and figures of the study, made from the records in results/ alone."""
